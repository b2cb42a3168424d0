// SPDX-License-Identifier: Apache-2.0
// A section: only a slab of the scene is shown, level, upright to an axis, or across the present view.
import * as THREE from 'three';

export class Section {
  constructor(box) {
    this.box = box;
    this.planes = [];
    this.way = 'off';
    this.place = 0.5;      // along the scene's extent in the direction of the section
    this.thickness = 0.15; // of that extent
    this.across = new THREE.Vector3(0, 1, 0);
  }

  set(way, camera) {
    this.way = way;
    if (way === 'across the view') {
      camera.getWorldDirection(this.across);
      this.across.setZ(0).normalize();
      if (this.across.lengthSq() === 0) this.across.set(0, 1, 0);
    }
    this.update();
  }

  normal() {
    return { level: new THREE.Vector3(0, 0, 1), 'along x': new THREE.Vector3(0, 1, 0), 'along y': new THREE.Vector3(1, 0, 0),
      'across the view': this.across }[this.way];
  }

  // The extent of the scene along a direction.
  range(n) {
    let low = Infinity, high = -Infinity;
    for (const x of [this.box.min.x, this.box.max.x]) for (const y of [this.box.min.y, this.box.max.y]) for (const z of [this.box.min.z, this.box.max.z]) {
      const d = n.dot(new THREE.Vector3(x, y, z));
      low = Math.min(low, d); high = Math.max(high, d);
    }
    return [low, high];
  }

  update() {
    this.planes.length = 0;
    if (this.way === 'off') return;
    const n = this.normal(), [low, high] = this.range(n), at = low + this.place * (high - low), half = (this.thickness * (high - low)) / 2;
    this.planes.push(new THREE.Plane(n.clone(), half - at), new THREE.Plane(n.clone().negate(), at + half));
  }

  words() {
    if (this.way === 'off') return '';
    const [low, high] = this.range(this.normal());
    return `${(this.thickness * (high - low)).toFixed(2)} m thick`;
  }
}
