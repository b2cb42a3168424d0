// SPDX-License-Identifier: Apache-2.0
// The thinned points, coloured by what they are, by plane, by residual, by height, or as measured.
import * as THREE from 'three';
import { ofClass, ofHeight, ofLabel, ofNumber, ofSign, otherClass } from './colours.js';

export class Points {
  constructor({ about, columns }, middle) {
    this.about = about;
    this.columns = columns;
    const n = about.count, place = new Float32Array(3 * n);
    for (let i = 0; i < n; ++i) {
      place[3 * i] = about.low[0] + about.step * columns.x[i] - middle.x;
      place[3 * i + 1] = about.low[1] + about.step * columns.y[i] - middle.y;
      place[3 * i + 2] = about.low[2] + about.step * columns.z[i] - middle.z;
    }
    this.place = place;
    this.hidden = new Set();  // labels that are not shown
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setAttribute('position', new THREE.BufferAttribute(place, 3));
    this.geometry.setAttribute('color', new THREE.BufferAttribute(new Uint8Array(3 * n), 3, true));
    this.material = new THREE.PointsMaterial({ size: 1.6, sizeAttenuation: false, vertexColors: true });
    this.object = new THREE.Points(this.geometry, this.material);
    this.colourBy(this.ways()[0]);
  }

  // The ways of colouring that the data allow.
  ways() {
    const c = this.columns, ways = [];
    if (c.label && this.hasAny(c.label)) ways.push('label');
    if (c.plane && this.hasAny(c.plane)) ways.push('plane');
    if (c.residual && this.hasAny(c.residual)) ways.push('residual');
    ways.push('height');
    if (c.unit && this.hasAny(c.unit)) ways.push('building');
    if (c.facade && this.hasAny(c.facade)) ways.push('facade');
    if (c.red) ways.push('colour');
    else if (c.intensity && this.hasAny(c.intensity)) ways.push('intensity');
    if (c.class && this.hasAny(c.class)) ways.push('class in the file');
    return ways;
  }
  hasAny(column) { return column.some((value) => value !== 0); }

  heights() {
    const sorted = Float32Array.from({ length: Math.min(20000, this.about.count) },
      (_, i) => this.place[3 * Math.floor((i * this.about.count) / Math.min(20000, this.about.count)) + 2]).sort();
    return [sorted[Math.floor(sorted.length * 0.01)] ?? 0, sorted[Math.floor(sorted.length * 0.99)] ?? 1];
  }

  colourBy(way) {
    this.way = way;
    const c = this.columns, colours = this.geometry.attributes.color.array, n = this.about.count;
    const [low, high] = this.heights(), most = Math.max(1, this.residualRange() / this.about.residual_step);
    const scale = Array.from({ length: 256 }, (_, i) => ofHeight(i / 255)), signs = Array.from({ length: 255 }, (_, i) => ofSign((i - 127) / most));
    const of = {
      label: (i) => ofLabel[c.label[i]] ?? otherClass,
      plane: (i) => ofNumber(c.plane[i]),
      residual: (i) => (c.plane && c.plane[i] === 0 ? [120, 125, 133] : signs[c.residual[i] + 127]),
      height: (i) => scale[Math.max(0, Math.min(255, Math.round((255 * (this.place[3 * i + 2] - low)) / Math.max(1e-6, high - low))))],
      building: (i) => ofNumber(c.unit[i]),
      facade: (i) => ofNumber(c.facade[i]),
      colour: (i) => [c.red[i], c.green[i], c.blue[i]],
      intensity: (i) => [c.intensity[i], c.intensity[i], c.intensity[i]],
      'class in the file': (i) => ofClass[c.class[i]] ?? otherClass,
    }[way];
    for (let i = 0; i < n; ++i) {
      const [r, g, b] = of(i);
      colours[3 * i] = r; colours[3 * i + 1] = g; colours[3 * i + 2] = b;
    }
    this.geometry.attributes.color.needsUpdate = true;
  }

  // Metres at which the colours of residuals end: what 95 of 100 residuals do not exceed.
  residualRange() {
    if (!this.columns.residual) return 0.05;
    if (this.range === undefined) {
      const values = [];
      for (let i = 0; i < this.about.count; ++i) if (this.columns.residual[i] !== 0) values.push(Math.abs(this.columns.residual[i]));
      values.sort((a, b) => a - b);
      this.range = Math.max(0.002, (values[Math.floor(values.length * 0.95)] ?? 25) * this.about.residual_step);
    }
    return this.range;
  }

  // The legend of the present colours: pairs of a CSS colour and words.
  legend(labels) {
    const css = ([r, g, b]) => `rgb(${r},${g},${b})`;
    if (this.way === 'label') {
      const used = new Set(this.columns.label);
      return [...used].sort((a, b) => a - b).map((v) => [css(ofLabel[v] ?? otherClass), labels[v] ?? 'none']);
    }
    if (this.way === 'residual') {
      const mm = Math.round(1000 * this.residualRange());
      return [[css(ofSign(-1)), `${mm} mm below`], [css(ofSign(0)), 'on the plane'], [css(ofSign(1)), `${mm} mm above`]];
    }
    if (this.way === 'height') {
      const [low, high] = this.heights();
      return [[css(ofHeight(0)), `${(high - low).toFixed(1)} m lower`], [css(ofHeight(1)), 'highest']];
    }
    return [];
  }

  // The number of the point nearest to a place on the screen (pixels), within some pixels; -1 where there is none.
  nearest(camera, width, height, x, y, planes, within = 7) {
    const m = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    let best = -1, bestDepth = Infinity;
    for (let i = 0; i < this.about.count; ++i) {
      const px = this.place[3 * i], py = this.place[3 * i + 1], pz = this.place[3 * i + 2];
      const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
      if (w <= 0) continue;
      const sx = ((m[0] * px + m[4] * py + m[8] * pz + m[12]) / w / 2 + 0.5) * width - x;
      const sy = (0.5 - (m[1] * px + m[5] * py + m[9] * pz + m[13]) / w / 2) * height - y;
      if (sx * sx + sy * sy > within * within) continue;
      if (planes.some((p) => p.normal.x * px + p.normal.y * py + p.normal.z * pz + p.constant < 0)) continue;
      const depth = w + Math.hypot(sx, sy) * 0.02 * w;
      if (depth < bestDepth) { bestDepth = depth; best = i; }
    }
    return best;
  }

  at(i) { return new THREE.Vector3(this.place[3 * i], this.place[3 * i + 1], this.place[3 * i + 2]); }
}
