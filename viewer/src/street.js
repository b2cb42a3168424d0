// SPDX-License-Identifier: Apache-2.0
// Objects on the street as boxes of their extents.
import * as THREE from 'three';
import { ofLabel, otherClass } from './colours.js';

export class Street {
  constructor(street, middle) {
    this.list = street.objects;
    this.boxes = new Map();
    this.object = new THREE.Group();
    const box = new THREE.BoxGeometry(1, 1, 1);
    this.mesh = new THREE.InstancedMesh(box, new THREE.MeshLambertMaterial({ transparent: true, opacity: 0.55 }), Math.max(1, this.list.length));
    this.mesh.count = this.list.length;
    const matrix = new THREE.Matrix4(), turn = new THREE.Quaternion(), up = new THREE.Vector3(0, 0, 1), edges = [];
    this.list.forEach((o, i) => {
      const size = new THREE.Vector3(Math.max(o[7], 20) / 100, Math.max(o[8], 20) / 100, Math.max(o[6], 20) / 100);
      const at = new THREE.Vector3(o[3] / 100 - middle.x, o[4] / 100 - middle.y, o[5] / 100 + size.z / 2 - middle.z);
      turn.setFromAxisAngle(up, (o[9] / 1800) * Math.PI);
      matrix.compose(at, turn, size);
      this.mesh.setMatrixAt(i, matrix);
      this.mesh.setColorAt(i, new THREE.Color(...(ofLabel[o[1]] ?? otherClass).map((c) => c / 255)));
      this.boxes.set(String(o[0]), new THREE.Box3().setFromCenterAndSize(at, new THREE.Vector3(size.x, size.x, size.z)));
      const line = new THREE.EdgesGeometry(box).applyMatrix4(matrix).attributes.position.array;
      for (const v of line) edges.push(v);
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(edges, 3));
    this.object.add(this.mesh, new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: 0x2d3748 })));
  }
}
