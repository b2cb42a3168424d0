// SPDX-License-Identifier: Apache-2.0
// Facade drawings in space: the lines of their elements where they are, over the orthoimage where there is one.
import * as THREE from 'three';
import { linesOf, trianglesOf } from './shapes.js';

const colourOfKind = { window: 0x2b83c6, door: 0x8e4fb5, opening: 0x2b83c6, outline: 0x6a7280, balcony: 0xcc79a7, sill: 0xd55e00, lintel: 0xd55e00,
  'possible opening': 0xefb81f, 'not seen': 0xefb81f };

// What was without points is white in the picture; in space one looks through it.
function clearWhite(g, picture) {
  g.drawImage(picture, 0, 0);
  const pixels = g.getImageData(0, 0, picture.width, picture.height);
  for (let i = 0; i < pixels.data.length; i += 4)
    if (Math.min(pixels.data[i], pixels.data[i + 1], pixels.data[i + 2]) > 236) pixels.data[i + 3] = 0;
  g.putImageData(pixels, 0, 0);
}

export class Facades {
  constructor(list, scene, middle) {
    this.object = new THREE.Group();
    this.targets = new THREE.Group();  // what a click meets; not drawn
    this.boxes = new Map();
    const ilot = window.ilot, lines = new Map(), hit = { triangles: [], of: [] };
    const at = (f, u, v, n) => ilot.facadeCorner(f, u, v, n).map((c, k) => c - middle.getComponent(k));
    for (const f of list) {
      const box = new THREE.Box3();
      for (const e of f.elements) {
        const ring = [];
        for (let i = 0; i < e.ring.length; i += 3) ring.push(at(f, e.ring[i], e.ring[i + 1], e.ring[i + 2] + 1));
        if (ring.length < 3) continue;
        ring.forEach((c) => box.expandByPoint(new THREE.Vector3(...c)));
        const colour = e.status === 2 ? 0xefb81f : (colourOfKind[e.kind] ?? 0x4a7c59);
        if (!lines.has(colour)) lines.set(colour, []);
        const own = lines.get(colour);
        for (let i = 0; i < ring.length; ++i) own.push(...ring[i], ...ring[(i + 1) % ring.length]);
        const triangles = trianglesOf([ring]);
        hit.triangles.push(...triangles);
        for (let i = 0; i < triangles.length / 9; ++i) hit.of.push([f.id, e.id, e.kind === 'outline' ? 0 : 1]);
      }
      if (!box.isEmpty()) this.boxes.set(String(f.id), box);
      this.addImage(f, scene, at);
    }
    for (const [colour, own] of lines) this.object.add(linesOf(own, colour));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(hit.triangles, 3));
    this.target = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ visible: true, side: THREE.DoubleSide }));
    this.target.userData.of = hit.of;
  }

  addImage(f, scene, at) {
    const image = f.image && document.querySelector(`[id="facade/${f.id}"] image.underlay`);
    if (!image || Math.abs(f.up[2] - 1) > 1e-3) return;
    const zero = f.origin[2] / 100 + scene.origin[2] * scene.metres_per_unit;  // the drawing's heights are those of the CRS
    const [x0, y0, x1, y1] = [f.image[0], f.image[1] - zero, f.image[2], f.image[3] - zero].map((v) => 100 * v);
    const corners = [at(f, x0, y0, 0), at(f, x1, y0, 0), at(f, x1, y1, 0), at(f, x0, y1, 0)];
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(corners.flat(), 3));
    geometry.setAttribute('uv', new THREE.Float32BufferAttribute([0, 0, 1, 0, 1, 1, 0, 1], 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const canvas = document.createElement('canvas'), texture = new THREE.CanvasTexture(canvas);
    const picture = new Image();
    picture.onload = () => {
      canvas.width = picture.width; canvas.height = picture.height;
      clearWhite(canvas.getContext('2d'), picture);
      texture.needsUpdate = true;
      mesh.visible = true;
      window.ilot.viewer?.redraw();
    };
    const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
      map: texture, alphaTest: 0.5, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2,
    }));
    mesh.visible = false;
    picture.src = image.getAttribute('href');
    this.object.add(mesh);
  }
}
