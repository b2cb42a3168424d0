// SPDX-License-Identifier: Apache-2.0
// The outlines of planes as thin sheets, each in a colour of its own.
import * as THREE from 'three';
import { ofNumber } from './colours.js';
import { edgesOf, linesOf, meshOf, trianglesOf } from './shapes.js';

export class Planes {
  // They are built when they are first shown: outlines of dense scans have many corners.
  constructor(bytes, middle, now) {
    this.object = new THREE.Group();
    this.boxes = new Map();
    this.middles = new Map();  // of planes, by id
    this.bytes = bytes;
    this.middle = middle;
    if (now) this.build();
  }

  // The middle of the largest triangle of a plane, which is on it.
  noteMiddle(id, triangles) {
    for (let i = 0; i < triangles.length; i += 9) {
      const [a, b, c] = [0, 3, 6].map((k) => new THREE.Vector3().fromArray(triangles, i + k)), middle = a.clone().add(b).add(c).divideScalar(3);
      const area = b.sub(a).cross(c.sub(a)).length();
      if (area > (this.middles.get(id)?.area ?? 0)) this.middles.set(id, { area, middle });
    }
  }

  build() {
    if (this.mesh) return;
    const { bytes, middle } = this;
    const numbers = new window.ilot.Numbers(bytes), triangles = [], colours = [], edges = [], ids = [];
    for (let n = numbers.whole(); n > 0; --n) {
      const id = numbers.whole(), box = new THREE.Box3();
      let x = 0, y = 0, z = 0;
      for (let parts = numbers.whole(); parts > 0; --parts) {
        const rings = [];
        for (let r = numbers.whole(); r > 0; --r) {
          const ring = [];
          for (let i = numbers.whole(); i > 0; --i) {
            x += numbers.signed(); y += numbers.signed(); z += numbers.signed();
            ring.push([x / 100 - middle.x, y / 100 - middle.y, z / 100 - middle.z]);
            box.expandByPoint(new THREE.Vector3(...ring[ring.length - 1]));
          }
          rings.push(ring);
        }
        if (rings.length === 0 || rings[0].length < 3) continue;
        for (const e of edgesOf(rings)) edges.push(e);
        const own = trianglesOf(rings), colour = ofNumber(id);
        for (const t of own) triangles.push(t);
        this.noteMiddle(String(id), own);
        for (let i = 0; i < own.length / 3; ++i) colours.push(...colour);
        for (let i = 0; i < own.length / 9; ++i) ids.push(id);
      }
      this.boxes.set(String(id), box);
    }
    const material = new THREE.MeshBasicMaterial({ vertexColors: true, side: THREE.DoubleSide, transparent: true, opacity: 0.5, depthWrite: false });
    this.mesh = meshOf(triangles, colours, material);
    this.mesh.userData.ids = ids;
    this.object.add(this.mesh, linesOf(edges, 0x5a6577));
  }
}
