// SPDX-License-Identifier: Apache-2.0
// Flat polygons with holes in space, cut into triangles.
import * as THREE from 'three';

// The normal of a ring of corners (lists of three numbers), by Newell's sum; not of unit length.
function normalOf(ring) {
  const n = [0, 0, 0];
  for (let i = 0; i < ring.length; ++i) {
    const a = ring[i], b = ring[(i + 1) % ring.length];
    n[0] += (a[1] - b[1]) * (a[2] + b[2]);
    n[1] += (a[2] - b[2]) * (a[0] + b[0]);
    n[2] += (a[0] - b[0]) * (a[1] + b[1]);
  }
  return n;
}

// Returns the corners of triangles, flat: nine numbers each. The first ring is the outer one.
export function trianglesOf(rings) {
  const n = normalOf(rings[0]), k = [0, 1, 2].reduce((best, i) => (Math.abs(n[i]) > Math.abs(n[best]) ? i : best), 0);
  const u = (k + 1) % 3, v = (k + 2) % 3;
  const flat = (ring) => ring.map((p) => new THREE.Vector2(p[u], p[v]));
  const all = rings.flat();
  const triangles = [];
  for (const [a, b, c] of THREE.ShapeUtils.triangulateShape(flat(rings[0]), rings.slice(1).map(flat))) {
    // Triangles keep the side of the ring.
    const cross = (all[b][u] - all[a][u]) * (all[c][v] - all[a][v]) - (all[b][v] - all[a][v]) * (all[c][u] - all[a][u]);
    const order = cross * n[k] >= 0 ? [a, b, c] : [a, c, b];
    for (const i of order) triangles.push(...all[i]);
  }
  return triangles;
}

// The edges of rings as pairs of corners, flat.
export function edgesOf(rings) {
  const lines = [];
  for (const ring of rings) for (let i = 0; i < ring.length; ++i) lines.push(...ring[i], ...ring[(i + 1) % ring.length]);
  return lines;
}

export function meshOf(triangles, colours, material) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(triangles, 3));
  geometry.setAttribute('color', new THREE.BufferAttribute(new Uint8Array(colours), 3, true));
  geometry.computeVertexNormals();
  return new THREE.Mesh(geometry, material);
}

export function linesOf(lines, colour) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(lines, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: colour }));
}
