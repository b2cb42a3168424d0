// SPDX-License-Identifier: Apache-2.0
// The distance between two clicked places.
import * as THREE from 'three';

export class Measure {
  constructor() {
    this.on = false;
    this.ends = [];
    this.object = new THREE.Group();
    const material = new THREE.LineBasicMaterial({ color: 0xc63a12, depthTest: false });
    this.line = new THREE.Line(new THREE.BufferGeometry(), material);
    this.dots = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ color: 0xc63a12, size: 8, sizeAttenuation: false, depthTest: false }));
    this.line.renderOrder = this.dots.renderOrder = 9;
    this.object.add(this.line, this.dots);
  }
  turn(on) { this.on = on; this.ends = []; this.show(); }
  add(place) {
    if (this.ends.length === 2) this.ends = [];
    this.ends.push(place);
    this.show();
  }
  show() {
    this.line.geometry.setFromPoints(this.ends.length === 2 ? this.ends : []);
    this.dots.geometry.setFromPoints(this.ends);
    this.object.visible = this.ends.length > 0;
  }
  words() {
    if (!this.on) return '';
    if (this.ends.length < 2) return this.ends.length === 0 ? 'click the first place' : 'click the second place';
    const [a, b] = this.ends, d = new THREE.Vector3().subVectors(b, a);
    return `${d.length().toFixed(3)} m; level ${Math.hypot(d.x, d.y).toFixed(3)} m, height ${d.z.toFixed(3)} m`;
  }
}
