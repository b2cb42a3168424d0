// SPDX-License-Identifier: Apache-2.0
// The view in 3D: what the page's data hold, put together. The page calls ilot.startViewer().
import * as THREE from 'three';
import { Buildings } from './buildings.js';
import { Facades } from './facades.js';
import { Measure } from './measure.js';
import { pick } from './pick.js';
import { Planes } from './planes.js';
import { Points } from './points.js';
import { Section } from './section.js';
import { Street } from './street.js';
import { Tools } from './tools.js';
import { View } from './view.js';

const { ilot } = window;

function hasWebGL() {
  try {
    return document.createElement('canvas').getContext('webgl2') !== null;
  } catch {
    return false;
  }
}

const cornersOf = (box) => Array.from({ length: 8 },
  (_, i) => new THREE.Vector3(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z));

// Some thousand points inside of the box, or its corners.
function placesOf(points, box) {
  if (!points) return cornersOf(box);
  const every = Math.max(1, Math.floor(points.about.count / 4000)), places = [];
  for (let i = 0; i < points.about.count; i += every) {
    const place = points.at(i);
    if (box.containsPoint(place)) places.push(place);
  }
  return places.length > 10 ? places : cornersOf(box);
}

// The box of the scene, in its metres: of the points without the outermost ones, else of the units.
async function boxOfScene(points) {
  const box = new THREE.Box3(), { about, columns } = points;
  if (about.count > 0) {
    for (const [k, name] of ['x', 'y', 'z'].entries()) {
      const sorted = columns[name].slice().sort(), at = (share) => about.low[k] + about.step * sorted[Math.floor(share * (sorted.length - 1))];
      box.min.setComponent(k, at(0.002));
      box.max.setComponent(k, at(0.998));
    }
    return box;
  }
  for (const b of (await ilot.outlines()).boxes)
    if (b) box.expandByPoint(new THREE.Vector3(b[0], b[1], 0)).expandByPoint(new THREE.Vector3(b[2], b[3], 20));
  for (const f of (await ilot.json('facades')) ?? [])
    for (const [u, v] of [[0, 0], [f.size_mm[0] / 10, f.size_mm[1] / 10]]) box.expandByPoint(new THREE.Vector3(...ilot.facadeCorner(f, u, v, 0)));
  return box.isEmpty() ? new THREE.Box3(new THREE.Vector3(0, 0, 0), new THREE.Vector3(10, 10, 10)) : box;
}

async function partsOfScene(scene, points, middle) {
  const [buildings, facades, street, outlines] =
    await Promise.all([ilot.json('buildings'), ilot.json('facades'), ilot.json('street'), ilot.bytes('plane-outlines')]);
  const parts = {};
  if (points.about.count > 0) parts.points = new Points(points, middle);
  if (buildings) parts.buildings = new Buildings(buildings, scene.building_tiles, middle);
  if (facades?.length) parts.facades = new Facades(facades, scene, middle);
  if (street?.objects.length) parts.street = new Street(street, middle);
  if (outlines) parts.planes = new Planes(outlines, middle, !parts.points);
  return parts;
}

// A unit that was selected, in a frame; the view goes there when that was asked elsewhere.
class Selection {
  constructor(view, parts) {
    this.view = view;
    this.parts = parts;
    this.frame = new THREE.Box3Helper(new THREE.Box3(), 0xc63a12);
    this.frame.visible = false;
    view.scene.add(this.frame);
  }
  async boxOf(unit) {
    const { buildings, facades, street, planes } = this.parts;
    if (unit.kind === 'building') {
      if (!buildings.boxes.has(unit.row) && unit.box) await buildings.loadAround((unit.box[0] + unit.box[2]) / 2, (unit.box[1] + unit.box[3]) / 2);
      return buildings.boxes.get(unit.row);
    }
    if (unit.kind === 'plane') planes?.build();
    return { facade: facades, object: street, plane: planes }[unit.kind]?.boxes.get(unit.id);
  }
  // From where a unit is seen best: a facade from its front, above what is across the street; a plane from its normal.
  async sideOf(unit) {
    if (unit.kind === 'facade') {
      const facades = await ilot.json('facades'), f = facades.find((one) => String(one.id) === unit.id);
      return new THREE.Vector3(...f.out).setZ(facades.length > 1 ? 1 : 0.25);
    }
    if (unit.kind === 'plane') {
      const planes = await ilot.json('planes'), i = planes.id.indexOf(Number(unit.id));
      const n = new THREE.Vector3(...planes.normal_e4.slice(3 * i, 3 * i + 3)).normalize();
      return n.z > 0.2 ? n : n.setZ(0.4);
    }
    return new THREE.Vector3(0.5, -1, 0.8);
  }
  async show(unit, from) {
    const box = unit ? await this.boxOf(unit) : null;
    this.frame.visible = Boolean(box);
    if (box) {
      this.frame.box.copy(box);
      if (from !== 'view') {
        const around = box.clone().expandByScalar(Math.max(2, box.getSize(new THREE.Vector3()).length() * 0.25));
        this.view.look(await this.sideOf(unit), cornersOf(around));
      }
    }
    this.view.redraw();
  }
}

// A click: a short press without a drag selects or measures.
function listenToClicks(view, parts, shown, measure, tools) {
  let down = null;
  view.canvas.addEventListener('pointerdown', (event) => { down = [event.offsetX, event.offsetY]; });
  view.canvas.addEventListener('pointerup', (event) => {
    if (!down || event.button !== 0 || Math.hypot(event.offsetX - down[0], event.offsetY - down[1]) > 4) return;
    view.canvas.focus({ preventScroll: true });
    const found = pick(view, parts, shown, event.offsetX, event.offsetY);
    if (measure.on) {
      if (found) measure.add(found.place.clone());
      tools.say();
      view.redraw();
      return;
    }
    let unit = found?.unit;
    if (unit?.[0] === 'unit') {  // the number of a building in the points
      const row = parts.buildings?.table.unit.indexOf(unit[1]) ?? -1;
      unit = row >= 0 ? ['building', parts.buildings.table.id[row]] : null;
    }
    ilot.select(...(unit ? [unit[0], unit[1], unit[2], 'view'] : [null]));
  });
}

ilot.startViewer = async function () {
  const place = document.getElementById('viewer');
  if (!hasWebGL()) return;
  const [scene, data] = await Promise.all([ilot.json('scene'), ilot.points()]);
  const whole = await boxOfScene(data), middle = whole.getCenter(new THREE.Vector3());
  const box = whole.clone().translate(middle.clone().negate());
  const parts = await partsOfScene(scene, data, middle);
  place.replaceChildren();
  const view = new View(place, box, placesOf(parts.points, box)), section = new Section(box), measure = new Measure();
  const shown = { points: Boolean(parts.points), buildings: true, facades: true, objects: true, planes: !parts.points };
  if (parts.buildings) await parts.buildings.loadAround(middle.x, middle.y);
  for (const part of Object.values(parts)) view.scene.add(part.object);
  view.scene.add(measure.object);
  const home = () => view.look(new THREE.Vector3(0.5, -1, 0.8));
  const tools = new Tools(place, view, parts, shown, section, measure, { home, labels: scene.labels });
  if (parts.buildings) // farther tiles are loaded where one looks
    view.controls.addEventListener('end', () => parts.buildings.loadAround(view.controls.target.x + middle.x, view.controls.target.y + middle.y).then(() => view.redraw()));
  const selection = new Selection(view, parts);
  listenToClicks(view, parts, shown, measure, tools);
  document.addEventListener('ilot:selected', ({ detail: { unit, from } }) => {
    ilot.viewer.settled = selection.show(unit, from);  // until the view has gone there
  });
  document.addEventListener('ilot:theme', () => view.draw());
  view.home();
  view.draw();
  ilot.viewer = {
    redraw: () => view.redraw(),
    // For tests and scripts: where a unit's middle is on the canvas, what is shown, how many points there are.
    onScreen: async (kind, id) => {
      const row = kind === 'building' ? parts.buildings.table.id.indexOf(id) : -1;
      const found = await selection.boxOf(kind === 'building' ? { kind, row, box: (await ilot.outlines()).boxes[row] } : { kind, id: String(id) });
      const middle = kind === 'plane' ? parts.planes.middles.get(String(id))?.middle : found?.getCenter(new THREE.Vector3());
      return middle ? view.onScreen(middle) : null;
    },
    shown, parts, view, tools,
  };
};
