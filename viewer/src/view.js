// SPDX-License-Identifier: Apache-2.0
// The camera, the light and the picture. A picture is drawn when something changed, and not before.
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

// Colours are those of the page, number for number: no conversion between colour spaces.
THREE.ColorManagement.enabled = false;

export class View {
  // `places`: some of what is shown, to find where all of it fits into the picture.
  constructor(place, box, places) {
    this.places = places;
    this.renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('aria-label', 'view of the result in 3D; press ? for the keys');
    place.prepend(this.canvas);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.1, 1000);
    this.camera.up.set(0, 0, 1);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0xaab2bb, 2.1), this.camera);
    const lamp = new THREE.DirectionalLight(0xffffff, 1.1);
    lamp.position.set(-0.4, 0.5, 1);
    this.camera.add(lamp);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.redraw());
    this.box = box;
    this.planes = [];
    new ResizeObserver(() => this.resize()).observe(place);
    this.resize();
  }

  // The first look: from the south-east of an even scene; across a long one, at its middle part.
  home() {
    const { along, width, length } = this.spread();
    const from = length > 3 * width ? new THREE.Vector3(along.y, -along.x, 0) : new THREE.Vector3(0.5, -1, 0);
    if (from.y > 0) from.negate();
    from.normalize().setZ(0.7);
    const near = length > 6 * width ? this.places.filter((p) => Math.abs(p.x * along.x + p.y * along.y) < 10 * width) : [];
    this.look(from, near.length > 10 ? near : this.places);
  }

  // The direction in which the places spread most in plan, and the standard deviations along and across it.
  spread() {
    let xx = 0, xy = 0, yy = 0;
    for (const p of this.places) { xx += p.x * p.x; xy += p.x * p.y; yy += p.y * p.y; }
    const n = Math.max(1, this.places.length), angle = Math.atan2(2 * xy, xx - yy) / 2, half = Math.hypot((xx - yy) / 2, xy);
    return { along: new THREE.Vector2(Math.cos(angle), Math.sin(angle)), length: Math.sqrt(((xx + yy) / 2 + half) / n),
      width: Math.sqrt(Math.max(0, (xx + yy) / 2 - half) / n) };
  }

  resize() {
    const { clientWidth: w, clientHeight: h } = this.canvas.parentNode;
    if (w === 0 || h === 0) return;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setSize(w, h, false);
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  // Looks at places from a direction (towards the eye), so that they fit.
  look(from, places = this.places) {
    const centre = new THREE.Box3().setFromPoints(places).getCenter(new THREE.Vector3()), tan = Math.tan((this.camera.fov / 2) * (Math.PI / 180)) * 0.94;
    this.controls.target.copy(centre);
    this.camera.position.copy(from).normalize().add(centre);
    this.controls.update();
    this.camera.updateMatrixWorld();
    // The least distance at which all places are in the picture.
    const x = new THREE.Vector3(), y = new THREE.Vector3(), z = new THREE.Vector3();
    this.camera.matrixWorld.extractBasis(x, y, z);
    let distance = 1;
    for (const place of places) {
      const corner = place.clone().sub(centre);
      const across = Math.max(Math.abs(corner.dot(x)) / this.camera.aspect, Math.abs(corner.dot(y)));
      distance = Math.max(distance, across / tan + corner.dot(z));
    }
    this.camera.position.copy(z).multiplyScalar(distance).add(centre);
    this.controls.update();
    this.redraw();
  }

  move(right, up) {
    const step = this.camera.position.distanceTo(this.controls.target) * 0.08;
    const x = new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right * step);
    const y = new THREE.Vector3(0, 0, up * step);
    if (Math.abs(this.camera.getWorldDirection(new THREE.Vector3()).z) > 0.4)
      y.copy(new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 1)).setZ(0).normalize().multiplyScalar(up * step);
    this.camera.position.add(x).add(y);
    this.controls.target.add(x).add(y);
    this.controls.update();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
  }

  clip(planes) {
    this.planes = planes;
    this.renderer.clippingPlanes = planes;
    this.redraw();
  }

  redraw() {
    this.asked ??= requestAnimationFrame(() => { this.asked = undefined; this.draw(); });
  }

  draw() {
    const distance = this.camera.position.distanceTo(this.box.getCenter(new THREE.Vector3())), size = this.box.getSize(new THREE.Vector3()).length();
    this.camera.far = distance + size + 10;
    this.camera.near = Math.max(this.camera.far / 20000, Math.min(1, distance / 100));
    this.camera.updateProjectionMatrix();
    this.scene.background = new THREE.Color(window.ilot.colour('--view'));
    this.renderer.render(this.scene, this.camera);
    this.onDraw?.();
  }

  // The place of a point of the scene on the canvas, in CSS pixels.
  onScreen(v) {
    this.camera.updateMatrixWorld();
    const p = v.clone().project(this.camera);
    return [(p.x / 2 + 0.5) * this.canvas.clientWidth, (0.5 - p.y / 2) * this.canvas.clientHeight];
  }

  ray(x, y) {
    const caster = new THREE.Raycaster();
    caster.setFromCamera(new THREE.Vector2((x / this.canvas.clientWidth) * 2 - 1, 1 - (y / this.canvas.clientHeight) * 2), this.camera);
    return caster;
  }
}
