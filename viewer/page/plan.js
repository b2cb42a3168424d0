// SPDX-License-Identifier: Apache-2.0
// The plan of the whole: a canvas that moves and zooms. Units are coloured by their quality and answer to a click.
{
  // The outlines of all buildings: for each its rings as flat lists of metres, and its box.
  ilot.outlines = function () {
    ilot.outlinesOnce ??= (async () => {
      const bytes = await ilot.bytes('outlines');
      const rings = [], boxes = [];
      if (!bytes) return { rings, boxes };
      for (const numbers = new ilot.Numbers(bytes); !numbers.done();) {
        const own = [], box = [Infinity, Infinity, -Infinity, -Infinity];
        let x = 0, y = 0;
        for (let r = numbers.whole(); r > 0; --r) {
          const ring = new Float32Array(2 * numbers.whole());
          for (let i = 0; i < ring.length; i += 2) {
            x += numbers.signed(); y += numbers.signed();
            ring[i] = x / 100; ring[i + 1] = y / 100;
            box[0] = Math.min(box[0], ring[i]); box[1] = Math.min(box[1], ring[i + 1]);
            box[2] = Math.max(box[2], ring[i]); box[3] = Math.max(box[3], ring[i + 1]);
          }
          own.push(ring);
        }
        rings.push(own); boxes.push(box[0] <= box[2] ? box : null);
      }
      return { rings, boxes };
    })();
    return ilot.outlinesOnce;
  };

  // What is drawn: layers from below, each with its units.
  async function layersOfPlan() {
    const [buildings, outlines, facades, street, points] =
      await Promise.all([ilot.json('buildings'), ilot.outlines(), ilot.json('facades'), ilot.json('street'), ilot.points()]);
    const layers = { points };
    if (buildings) {
      const rank = buildings.quality.words.map((word) => Math.max(0, ilot.qualities.indexOf(word)));
      layers.buildings = buildings.id.map((id, i) => ({ id, rings: outlines.rings[i], box: outlines.boxes[i], rank: rank[buildings.quality.rows[i]] }))
        .filter((b) => b.box);
    }
    if (facades?.length)
      layers.walls = facades.map((f) => {
        const a = ilot.facadeCorner(f, 0, 0, 0), b = ilot.facadeCorner(f, f.size_mm[0] / 10, 0, 0);
        return { id: f.id, line: [a[0], a[1], b[0], b[1]], rank: ilot.facadeQuality(f) };
      });
    if (street) {
      layers.blocks = street.blocks.map((p) => p.slice(2, 6).map((v) => v / 100));
      layers.gaps = street.gaps.map((p) => p.slice(2, 6).map((v) => v / 100));
      layers.objects = street.objects.map((o) => ({ id: o[0], at: [o[3] / 100, o[4] / 100], size: [Math.max(o[7], 30) / 100, Math.max(o[8], 30) / 100],
        turn: (o[9] / 1800) * Math.PI, rank: ilot.objectQuality(o) }));
    }
    return layers;
  }

  function extentOf(layers) {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    const add = (x, y) => { box[0] = Math.min(box[0], x); box[1] = Math.min(box[1], y); box[2] = Math.max(box[2], x); box[3] = Math.max(box[3], y); };
    for (const b of layers.buildings ?? []) { add(b.box[0], b.box[1]); add(b.box[2], b.box[3]); }
    for (const w of layers.walls ?? []) { add(w.line[0], w.line[1]); add(w.line[2], w.line[3]); }
    for (const o of layers.objects ?? []) add(...o.at);
    const { about, columns } = layers.points;
    if (box[0] > box[2])
      for (let i = 0; i < about.count; ++i) add(about.low[0] + about.step * columns.x[i], about.low[1] + about.step * columns.y[i]);
    return box[0] <= box[2] ? box : [0, 0, 1, 1];
  }

  class Plan {
    constructor(canvas, layers) {
      this.canvas = canvas; this.layers = layers;
      this.shown = { points: true, buildings: true, walls: true, blocks: true, objects: true };
      this.extent = extentOf(layers);
      this.fit(this.extent);
    }
    fit(box, margin = 1.08) {
      const { clientWidth: w, clientHeight: h } = this.canvas;
      this.scale = Math.min(w / Math.max(1, (box[2] - box[0]) * margin), h / Math.max(1, (box[3] - box[1]) * margin));
      this.middle = [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];
    }
    x(v) { return this.canvas.clientWidth / 2 + (v - this.middle[0]) * this.scale; }
    y(v) { return this.canvas.clientHeight / 2 - (v - this.middle[1]) * this.scale; }
    place(px, py) {
      return [this.middle[0] + (px - this.canvas.clientWidth / 2) / this.scale, this.middle[1] - (py - this.canvas.clientHeight / 2) / this.scale];
    }
    path(rings) {
      const path = new Path2D();
      for (const ring of rings) {
        for (let i = 0; i < ring.length; i += 2) path[i === 0 ? 'moveTo' : 'lineTo'](this.x(ring[i]), this.y(ring[i + 1]));
        path.closePath();
      }
      return path;
    }
    cornersOf(o) {
      const c = Math.cos(o.turn), s = Math.sin(o.turn), [l, w] = [o.size[0] / 2, o.size[1] / 2];
      return [[l, w], [-l, w], [-l, -w], [l, -w]].flatMap(([a, b]) => [o.at[0] + a * c - b * s, o.at[1] + a * s + b * c]);
    }
    // Points are put into an image: a rectangle each would take seconds.
    drawPoints(g, ratio) {
      const { about, columns } = this.layers.points, width = this.canvas.width, height = this.canvas.height;
      const image = g.getImageData(0, 0, width, height), pixels = new Uint32Array(image.data.buffer);
      const ink = ilot.colour('--point').match(/^#(..)(..)(..)$/).slice(1).map((part) => parseInt(part, 16));
      const word = 0xff000000 | (ink[2] << 16) | (ink[1] << 8) | ink[0];
      const x0 = this.x(about.low[0]) * ratio, y0 = this.y(about.low[1]) * ratio, step = about.step * this.scale * ratio;
      for (let i = 0; i < about.count; ++i) {
        const x = Math.floor(x0 + step * columns.x[i]), y = Math.floor(y0 - step * columns.y[i]);
        if (x >= 0 && y >= 0 && x < width && y < height) pixels[y * width + x] = word;
      }
      g.putImageData(image, 0, 0);
    }
    drawBuildings(g, colours) {
      g.lineWidth = 1;
      for (const b of this.layers.buildings) {
        if (this.x(b.box[2]) < 0 || this.y(b.box[1]) < 0 || this.x(b.box[0]) > this.canvas.clientWidth || this.y(b.box[3]) > this.canvas.clientHeight) continue;
        const path = this.path(b.rings);
        g.fillStyle = g.strokeStyle = colours[b.rank];
        g.globalAlpha = b.rank === 3 ? 0.25 : 0.55;
        g.fill(path, 'evenodd');
        g.globalAlpha = 1;
        g.stroke(path);
      }
    }
    drawLines(g, lines, dash) {
      g.setLineDash(dash);
      g.beginPath();
      for (const l of lines) { g.moveTo(this.x(l[0]), this.y(l[1])); g.lineTo(this.x(l[2]), this.y(l[3])); }
      g.stroke();
      g.setLineDash([]);
    }
    draw() {
      const { canvas, layers, shown } = this;
      const ratio = Math.min(3, (window.devicePixelRatio || 1) * (this.printing ? 2 : 1));
      canvas.width = canvas.clientWidth * ratio; canvas.height = canvas.clientHeight * ratio;
      const g = canvas.getContext('2d', { willReadFrequently: true });
      g.scale(ratio, ratio);
      g.fillStyle = ilot.colour('--view');
      g.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
      const colours = [0, 1, 2, 3, 4].map((i) => ilot.colour('--s' + i));
      if (shown.points && layers.points.about.count) this.drawPoints(g, ratio);
      if (shown.buildings && layers.buildings) this.drawBuildings(g, colours);
      if (shown.blocks && layers.blocks) {
        g.strokeStyle = ilot.colour('--soft'); g.lineWidth = 2;
        this.drawLines(g, layers.blocks, []);
        g.lineWidth = 1;
        this.drawLines(g, layers.gaps, [4, 4]);
      }
      if (shown.walls && layers.walls)
        for (const rank of [4, 3, 0, 1, 2]) {
          g.strokeStyle = colours[rank]; g.lineWidth = Math.max(1, Math.min(3, 0.8 * this.scale));
          this.drawLines(g, layers.walls.filter((w) => w.rank === rank).map((w) => w.line), []);
        }
      if (shown.objects && layers.objects)
        for (const o of layers.objects) { g.fillStyle = colours[o.rank]; g.fill(this.path([this.cornersOf(o)])); }
      this.drawSelected(g);
      this.drawScale(g);
    }
    drawSelected(g) {
      const unit = ilot.selected;
      if (!unit?.box) return;
      const [a, b, c, d] = unit.box;
      g.strokeStyle = ilot.colour('--ink'); g.lineWidth = 2;
      g.strokeRect(this.x(a) - 5, this.y(d) - 5, (c - a) * this.scale + 10, (d - b) * this.scale + 10);
    }
    drawScale(g) {
      const wanted = 120 / this.scale, power = 10 ** Math.floor(Math.log10(wanted));
      const length = [5, 2, 1].map((f) => f * power).find((v) => v <= wanted) ?? power;
      const x = 14, y = this.canvas.clientHeight - 14;
      g.strokeStyle = g.fillStyle = ilot.colour('--ink'); g.lineWidth = 1.5;
      g.beginPath();
      g.moveTo(x, y - 5); g.lineTo(x, y); g.lineTo(x + length * this.scale, y); g.lineTo(x + length * this.scale, y - 5);
      g.stroke();
      g.font = '12px system-ui, sans-serif';
      g.fillText(`${length} m, north is up`, x + length * this.scale + 8, y);
    }
    // The unit at a place of the canvas: the topmost one within a few pixels.
    unitAt(px, py) {
      const [x, y] = this.place(px, py), near = 5 / this.scale;
      const inRing = (ring) => {
        let inside = false;
        for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2)
          if (ring[i + 1] > y !== ring[j + 1] > y && x < ((ring[j] - ring[i]) * (y - ring[i + 1])) / (ring[j + 1] - ring[i + 1]) + ring[i]) inside = !inside;
        return inside;
      };
      const toLine = ([ax, ay, bx, by]) => {
        const t = Math.max(0, Math.min(1, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2 || 1)));
        return Math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay));
      };
      const { layers, shown } = this;
      const object = shown.objects && layers.objects?.find((o) => Math.hypot(o.at[0] - x, o.at[1] - y) < Math.max(near, o.size[0] / 2));
      if (object) return ['object', object.id];
      const wall = shown.walls && layers.walls?.find((w) => toLine(w.line) < near);
      if (wall) return ['facade', wall.id];
      const building = shown.buildings && layers.buildings?.find((b) => x >= b.box[0] && x <= b.box[2] && y >= b.box[1] && y <= b.box[3] &&
        b.rings.reduce((inside, ring) => inside !== inRing(ring), false));
      return building ? ['building', building.id] : null;
    }
  }

  function listen(plan) {
    const { canvas } = plan;
    let down = null;
    const redraw = () => { plan.asked ??= requestAnimationFrame(() => { plan.asked = undefined; plan.draw(); }); };
    plan.redraw = redraw;
    canvas.addEventListener('pointerdown', (e) => { down = [e.offsetX, e.offsetY, 0]; canvas.setPointerCapture(e.pointerId); });
    canvas.addEventListener('pointermove', (e) => {
      if (!down) { canvas.style.cursor = plan.unitAt(e.offsetX, e.offsetY) ? 'pointer' : 'grab'; return; }
      plan.middle[0] -= (e.offsetX - down[0]) / plan.scale; plan.middle[1] += (e.offsetY - down[1]) / plan.scale;
      down = [e.offsetX, e.offsetY, down[2] + Math.abs(e.offsetX - down[0]) + Math.abs(e.offsetY - down[1])];
      redraw();
    });
    canvas.addEventListener('pointerup', (e) => {
      const moved = down?.[2] ?? 9;
      down = null;
      if (moved > 4) return;
      const unit = plan.unitAt(e.offsetX, e.offsetY);
      ilot.select(...(unit ? [unit[0], unit[1], undefined, 'plan'] : [null]));
    });
    const zoom = (factor, px, py) => {
      const before = plan.place(px, py);
      plan.scale = Math.max(1e-4, Math.min(2000, plan.scale * factor));
      const after = plan.place(px, py);
      plan.middle[0] += before[0] - after[0]; plan.middle[1] += before[1] - after[1];
      redraw();
    };
    canvas.addEventListener('wheel', (e) => {
      if (!e.ctrlKey && document.activeElement !== canvas) return;  // the page scrolls until the plan was clicked
      e.preventDefault();
      zoom(2 ** (-e.deltaY / 300), e.offsetX, e.offsetY);
    }, { passive: false });
    canvas.addEventListener('keydown', (e) => {
      const step = 60 / plan.scale, w = canvas.clientWidth / 2, h = canvas.clientHeight / 2;
      const moves = { ArrowLeft: () => (plan.middle[0] -= step), ArrowRight: () => (plan.middle[0] += step), ArrowUp: () => (plan.middle[1] += step),
        ArrowDown: () => (plan.middle[1] -= step), '+': () => zoom(1.3, w, h), '-': () => zoom(1 / 1.3, w, h), h: () => plan.fit(plan.extent) };
      if (!moves[e.key]) return;
      e.preventDefault(); moves[e.key](); redraw();
    });
    return { redraw, zoom };
  }

  function addTools(plan, { redraw, zoom }) {
    const tools = plan.canvas.parentNode.querySelector('.plan-tools'), w = () => plan.canvas.clientWidth / 2, h = () => plan.canvas.clientHeight / 2;
    const button = (text, title, onclick) => tools.append(ilot.make('button', { textContent: text, title, onclick }));
    button('+', 'closer', () => zoom(1.5, w(), h()));
    button('−', 'farther', () => zoom(1 / 1.5, w(), h()));
    button('all', 'everything', () => { plan.fit(plan.extent); redraw(); });
    const { layers } = plan;
    for (const name of ['points', 'buildings', 'walls', 'blocks', 'objects'])
      if (name === 'points' ? layers.points.about.count : layers[name]?.length) {
        const toggle = ilot.make('button', { textContent: name, ariaPressed: 'true' });
        toggle.onclick = () => { plan.shown[name] = !plan.shown[name]; toggle.ariaPressed = String(plan.shown[name]); redraw(); };
        tools.append(toggle);
      }
  }

  function addLegend(layers) {
    const legend = document.getElementById('plan-legend');
    const line = (what, list, names) => {
      if (!list?.length) return;
      const used = [...new Set(list.map((unit) => unit.rank))].sort();
      legend.append(ilot.make('div', {}, what + ': ', ...used.map((rank) =>
        ilot.make('span', {}, ilot.make('i', { className: 'series-' + rank }), names[rank]))));
    };
    line('buildings by their quality', layers.buildings, ilot.qualityNames);
    line('facades by the error that 95 % of their seen edges keep', layers.walls, ['10 mm', '30 mm', 'more than 30 mm', '', 'not stated']);
    line('objects by the probability of their class', layers.objects, ['80 % or more', '50 % or more', 'less than 50 %']);
  }

  ilot.startPlan = async function () {
    const canvas = document.querySelector('.plan canvas');
    if (!canvas) return;
    const layers = await layersOfPlan();
    const plan = (ilot.plan = new Plan(canvas, layers));
    const tools = listen(plan);
    addTools(plan, tools);
    addLegend(layers);
    document.addEventListener('ilot:selected', ({ detail: { unit, from } }) => {
      if (unit?.box && from !== 'plan') {
        const around = Math.max(30, unit.box[2] - unit.box[0], unit.box[3] - unit.box[1]);
        plan.fit([unit.box[0] - around, unit.box[1] - around, unit.box[2] + around, unit.box[3] + around]);
      }
      tools.redraw();
    });
    document.addEventListener('ilot:theme', tools.redraw);
    new ResizeObserver(tools.redraw).observe(canvas);
    plan.draw();
  };
}
