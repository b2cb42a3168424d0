// SPDX-License-Identifier: Apache-2.0
// The buttons over the view and the keys.
import * as THREE from 'three';

const keyHelp = [['drag, right drag, wheel', 'turn, move, closer'], ['arrows or W A S D', 'move'], ['+ −', 'closer, farther'],
  ['H', 'all'], ['T', 'from above'], ['F', 'from the south'], ['click', 'what is there'], ['M', 'measure'], ['X', 'section'],
  ['[ ]', 'move the section'], ['P', 'points'], ['O', 'planes'], ['B', 'buildings'], ['C', 'colours of points'], ['Esc', 'nothing selected'], ['?', 'these keys']];

export class Tools {
  constructor(place, view, parts, shown, section, measure, hooks) {
    Object.assign(this, { place, view, parts, shown, section, measure, hooks });
    const make = window.ilot.make;
    this.make = make;
    this.bar = make('div', { className: 'tools' });
    this.hint = make('div', { className: 'hint' });
    this.hint.setAttribute('role', 'status');
    this.legend = make('div', { className: 'scale legend' });
    this.keys = make('div', { className: 'keys', hidden: true },
      make('table', {}, make('tbody', {}, ...keyHelp.map(([key, what]) => make('tr', {}, make('td', { textContent: key }), make('td', { textContent: what }))))));
    place.append(this.bar, this.hint, this.legend, this.keys);
    this.addLayers();
    this.addSection();
    this.measureButton = this.button('measure', 'distance between two places (M)', () => this.toggleMeasure());
    this.button('all', 'everything (H)', () => hooks.home());
    this.button('above', 'from above (T)', () => view.look(new THREE.Vector3(0, -0.001, 1)));
    this.button('?', 'keys', () => { this.keys.hidden = !this.keys.hidden; });
    view.canvas.addEventListener('keydown', (event) => this.key(event));
    this.say();
  }

  button(text, title, onclick) {
    const button = this.make('button', { textContent: text, title, onclick });
    this.bar.append(button);
    return button;
  }

  addLayers() {
    this.toggles = {};
    for (const name of ['points', 'buildings', 'facades', 'objects', 'planes']) {
      const part = { points: this.parts.points, buildings: this.parts.buildings, facades: this.parts.facades, objects: this.parts.street, planes: this.parts.planes }[name];
      if (!part) continue;
      const button = this.button(name, `show or hide ${name}`, () => this.toggle(name));
      button.ariaPressed = String(this.shown[name]);
      this.toggles[name] = { button, part };
      part.object.visible = this.shown[name];
      if (name === 'points') this.addColours();
    }
  }

  addColours() {
    this.colours = this.make('select', { title: 'colours of points (C)' },
      ...this.parts.points.ways().map((way) => this.make('option', { value: way, textContent: 'by ' + way })));
    this.colours.value = this.parts.points.way;
    this.colours.onchange = () => { this.parts.points.colourBy(this.colours.value); this.say(); this.view.redraw(); };
    this.bar.append(this.colours);
  }

  addSection() {
    const { section, make } = this;
    this.ways = make('select', { title: 'section (X)' },
      ...['off', 'level', 'along x', 'along y', 'across the view'].map((way) => make('option', { value: way, textContent: way === 'off' ? 'no section' : 'section ' + way })));
    this.slide = make('input', { type: 'range', min: 0, max: 1, step: 0.002, value: section.place, title: 'place of the section ([ ])', hidden: true });
    this.thick = make('input', { type: 'range', min: 0.004, max: 1, step: 0.002, value: section.thickness, title: 'thickness of the section', hidden: true });
    const update = () => { section.place = Number(this.slide.value); section.thickness = Number(this.thick.value); section.update(); this.clip(); };
    this.ways.onchange = () => { section.set(this.ways.value, this.view.camera); this.clip(); };
    this.slide.oninput = this.thick.oninput = update;
    this.bar.append(this.ways, this.slide, this.thick);
  }

  clip() {
    this.slide.hidden = this.thick.hidden = this.section.way === 'off';
    this.view.clip([...this.section.planes]);
    this.say();
  }

  toggle(name) {
    const { button, part } = this.toggles[name] ?? {};
    if (!part) return;
    this.shown[name] = !this.shown[name];
    button.ariaPressed = String(this.shown[name]);
    if (this.shown[name]) part.build?.();
    part.object.visible = this.shown[name];
    this.view.redraw();
  }

  toggleMeasure() {
    this.measure.turn(!this.measure.on);
    this.measureButton.ariaPressed = String(this.measure.on);
    this.say();
    this.view.redraw();
  }

  // The line at the bottom: the measure, else the section, else how many points are shown.
  say() {
    const { points } = this.parts;
    const thin = points && points.about.count < points.about.of;
    const shown = points ? points.about.problem ?? `${points.about.count.toLocaleString('en')}${thin ? ' of ' + points.about.of.toLocaleString('en') : ''} points` : '';
    this.hint.textContent = this.measure.words() || this.section.words() || shown;
    const labels = this.hooks.labels;
    this.legend.replaceChildren(...(points && this.shown.points ? points.legend(labels) : []).map(([colour, words]) => {
      const swatch = this.make('i');
      swatch.style.background = colour;
      return this.make('span', {}, swatch, words);
    }));
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { view } = this;
    const step = (by) => { if (this.section.way === 'off') return; this.slide.value = Number(this.slide.value) + by; this.slide.oninput(); };
    const next = (select) => { select.selectedIndex = (select.selectedIndex + 1) % select.options.length; select.onchange(); };
    const keys = { arrowleft: () => view.move(-1, 0), a: () => view.move(-1, 0), arrowright: () => view.move(1, 0), d: () => view.move(1, 0),
      arrowup: () => view.move(0, 1), w: () => view.move(0, 1), arrowdown: () => view.move(0, -1), s: () => view.move(0, -1),
      '+': () => view.zoom(0.8), '=': () => view.zoom(0.8), '-': () => view.zoom(1.25), h: () => this.hooks.home(),
      t: () => view.look(new THREE.Vector3(0, -0.001, 1)), f: () => view.look(new THREE.Vector3(0, -1, 0.15)), m: () => this.toggleMeasure(),
      x: () => next(this.ways), '[': () => step(-0.01), ']': () => step(0.01), p: () => this.toggle('points'), o: () => this.toggle('planes'),
      b: () => this.toggle('buildings'), c: () => this.colours && next(this.colours), escape: () => window.ilot.select(null),
      '?': () => { this.keys.hidden = !this.keys.hidden; } };
    const action = keys[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  }
}
