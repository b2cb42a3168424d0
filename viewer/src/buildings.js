// SPDX-License-Identifier: Apache-2.0
// The solids of buildings, tile by tile: roofs in the colour of their quality, walls grey.
import * as THREE from 'three';
import { ofStyle } from './colours.js';
import { edgesOf, linesOf, meshOf, trianglesOf } from './shapes.js';

const roof = 0, wall = 1;

// Reads one building of a tile: its row and its faces as rings of corners in metres.
function readBuilding(numbers, middle) {
  const row = numbers.whole(), corners = [];
  let x = 0, y = 0, z = 0;
  for (let n = numbers.whole(); n > 0; --n) {
    x += numbers.signed(); y += numbers.signed(); z += numbers.signed();
    corners.push([x / 100 - middle.x, y / 100 - middle.y, z / 100 - middle.z]);
  }
  const faces = [];
  for (let n = numbers.whole(); n > 0; --n) {
    const kind = numbers.whole(), rings = [];
    for (let r = numbers.whole(); r > 0; --r) {
      const ring = [];
      for (let i = numbers.whole(); i > 0; --i) ring.push(corners[numbers.whole()]);
      rings.push(ring);
    }
    faces.push({ kind, rings });
  }
  return { row, corners, faces };
}

export class Buildings {
  constructor(table, tiles, middle) {
    this.table = table;
    this.tiles = tiles;
    this.middle = middle;
    this.object = new THREE.Group();
    this.boxes = new Map();  // row -> THREE.Box3
    this.loaded = new Set();
    this.material = new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    const ilot = window.ilot;
    this.rank = table.quality.words.map((word) => Math.max(0, ilot.qualities.indexOf(word)));
  }

  rankOf(row) { return this.rank[this.table.quality.rows[row]]; }

  async load(tile) {
    if (this.loaded.has(tile.name)) return;
    this.loaded.add(tile.name);
    const numbers = new window.ilot.Numbers(await window.ilot.tileBytes(tile));
    const triangles = [], colours = [], edges = [], rows = [];
    const roofs = [0, 1, 2, 3, 4].map((i) => ofStyle('--s' + i)), grey = [186, 190, 197];
    while (!numbers.done()) {
      const b = readBuilding(numbers, this.middle);
      this.boxes.set(b.row, new THREE.Box3().setFromPoints(b.corners.map((c) => new THREE.Vector3(...c))));
      const solid = b.faces.some((f) => f.kind === roof);
      for (const face of b.faces) {
        if (face.rings.length === 0 || face.rings[0].length < 3) continue;
        for (const e of edgesOf(face.rings)) edges.push(e);
        if (solid && face.kind !== roof && face.kind !== wall) continue;
        const own = trianglesOf(face.rings), colour = face.kind === wall ? grey : roofs[this.rankOf(b.row)];
        for (const t of own) triangles.push(t);
        for (let i = 0; i < own.length / 3; ++i) colours.push(...colour);
        for (let i = 0; i < own.length / 9; ++i) rows.push(b.row);
      }
    }
    const mesh = meshOf(triangles, colours, this.material);
    mesh.userData.rows = rows;
    this.object.add(mesh, linesOf(edges, 0x20262e));
  }

  // Loads the tiles nearest to a place (of the scene, without the middle) up to a number of buildings.
  async loadAround(x, y, most = 4000) {
    const distance = ({ box }) => Math.hypot(Math.max(box[0] - x, 0, x - box[2]), Math.max(box[1] - y, 0, y - box[3]));
    let buildings = 0;
    for (const tile of [...this.tiles].sort((a, b) => distance(a) - distance(b))) {
      if (buildings > 0 && buildings + tile.buildings > most) break;
      buildings += tile.buildings;
      await this.load(tile);
    }
  }
}
