// SPDX-License-Identifier: Apache-2.0
// Any unit by its link: report.html#building/17912, #facade/3, #facade/3/12 (an element), #object/7, #plane/41.
{
  const metres = (value, per, digits) => (value === null || value === undefined ? '' : (value / per).toFixed(digits) + ' m');
  const percent = (permille) => (permille === null || permille === undefined ? '' : (permille / 10).toFixed(1) + ' %');
  const count = (value) => value.toLocaleString('en');

  async function building(id) {
    const b = await ilot.json('buildings');
    const i = b ? b.id.indexOf(id) : -1;
    if (i < 0) return null;
    const word = (column) => b[column].words[b[column].rows[i]];
    return {
      kind: 'building', id, row: i, title: 'Building ' + id,
      facts: [['quality', ilot.qualityNames[Math.max(0, ilot.qualities.indexOf(word('quality')))]], ['why', word('reason')],
        ['status', word('status')], ['RMSE', metres(b.rmse_mm[i], 1000, 3)], ['95 % within', metres(b.p95_mm[i], 1000, 3)],
        ['points explained', percent(b.explained_pm[i])], ['outline covered', percent(b.coverage_pm[i])],
        ['area', b.area_dm2[i] === null ? '' : (b.area_dm2[i] / 100).toFixed(1) + ' m²'],
        ['height', metres(b.height_cm[i], 100, 2)], ['roof faces', count(b.faces[i])], ['points', count(b.points[i])],
        ['unit_id in points/', count(b.unit[i])]],
      box: (await ilot.outlines()).boxes[i],
    };
  }

  const statuses = ['seen', 'completed', 'occluded', 'by hand'];
  const corner = (f, u, v, n) => [0, 1, 2].map((k) => (f.origin[k] + u * f.right[k] + v * f.up[k] + n * f.out[k]) / 100);
  ilot.facadeCorner = corner;

  async function facade(id, element) {
    const f = (await ilot.json('facades'))?.find((one) => String(one.id) === id);
    if (!f) return null;
    const ends = [corner(f, 0, 0, 0), corner(f, f.size_mm[0] / 10, f.size_mm[1] / 10, 0)];
    const box = [Math.min(ends[0][0], ends[1][0]), Math.min(ends[0][1], ends[1][1]), Math.max(ends[0][0], ends[1][0]),
      Math.max(ends[0][1], ends[1][1])];
    const e = element === undefined ? null : f.elements.find((one) => String(one.id) === element);
    if (element !== undefined && !e) return null;
    if (!e) {
      const of = (status) => f.elements.filter((one) => one.status === status).length;
      return { kind: 'facade', id, title: 'Facade ' + id, box,
        facts: [['width', metres(f.size_mm[0], 1000, 2)], ['height', metres(f.size_mm[1], 1000, 2)],
          ['elements', count(f.elements.length)], ['openings', count(f.elements.filter((one) => one.opening).length)],
          ['not wholly seen', count(of(1) + of(2))],
          ['95 % of seen edges within', f.error_mm > 0 ? f.error_mm + ' mm' : 'not stated']] };
    }
    const stated = (k) => (e.error_mm[k] > 0 ? ` ± ${e.error_mm[k]} mm` : '') || (e.status === 3 ? ', by hand' : '');
    const sized = (k) => metres(e.mm[k], 1000, 3) + stated(k);
    return { kind: 'facade', id, element, title: `Facade ${id}: ${e.kind} ${e.id}`, box,
      facts: [['width', sized(0)], ['height', sized(1)], ['depth', sized(2)],
        ['row, column', e.at[0] ? e.at[0] + ', ' + e.at[1] : ''], ['status', statuses[e.status]], ['why', e.reason],
        ['worst edge within', e.error_mm[3] > 0 ? e.error_mm[3] + ' mm' : ''], ['points', count(e.points)]] };
  }

  async function object(id) {
    const [street, scene] = await Promise.all([ilot.json('street'), ilot.json('scene')]);
    const o = street?.objects.find((one) => String(one[0]) === id);
    if (!o) return null;
    const half = Math.max(o[7], o[8], 100) / 200;
    return { kind: 'object', id, title: `Object ${id}: ${scene.labels[o[1]]}`,
      box: [o[3] / 100 - half, o[4] / 100 - half, o[3] / 100 + half, o[4] / 100 + half],
      facts: [['probability', percent(o[2])], ['height', metres(o[6], 100, 2)], ['length', metres(o[7], 100, 2)],
        ['width', metres(o[8], 100, 2)], ['heading', (o[9] / 10).toFixed(0) + '°'], ['points', count(o[10])],
        ['block', o[11] ? o[11] + '.' + o[12] : '']] };
  }

  async function plane(id) {
    const p = await ilot.json('planes');
    const i = p ? p.id.indexOf(Number(id)) : -1;
    if (i < 0) return null;
    const half = Math.sqrt(Math.max(p.area_dm2[i], 100) / 100) / 2, c = p.centre_cm.slice(3 * i, 3 * i + 3).map((v) => v / 100);
    const n = p.normal_e4.slice(3 * i, 3 * i + 3).map((v) => v / 1e4);
    return { kind: 'plane', id, title: 'Plane ' + id, box: [c[0] - half, c[1] - half, c[0] + half, c[1] + half],
      facts: [['area', (p.area_dm2[i] / 100).toFixed(2) + ' m²'], ['RMS', (p.rms_um[i] / 1000).toFixed(1) + ' mm'],
        ['no point beyond', p.epsilon_mm[i] + ' mm'], ['slope', ((Math.acos(Math.min(1, Math.abs(n[2]))) * 180) / Math.PI).toFixed(1) + '°'],
        ['normal', n.map((v) => v.toFixed(3)).join(', ')], ['confidence', percent(p.confidence_pm[i])],
        ['neighbours', count(p.neighbours[i])], ['points', count(p.points[i])]] };
  }

  const finders = { building, facade, object, plane };

  function show(unit) {
    const panel = document.getElementById('unit');
    const make = ilot.make;
    const rows = unit.facts.filter(([, value]) => value !== '' && value !== undefined)
      .map(([name, value]) => make('tr', {}, make('td', { textContent: name }), make('td', { textContent: value })));
    const go = (where) => () => document.getElementById(where).scrollIntoView({ behavior: 'smooth' });
    const actions = [make('button', { textContent: 'in the plan', onclick: go('plan') })];
    if (ilot.viewer) actions.push(make('button', { textContent: 'in 3D', onclick: go('view') }));
    if (unit.kind === 'facade' && document.getElementById('facade/' + unit.id))
      actions.push(make('button', { textContent: 'its drawing', onclick: go('facade/' + unit.id) }));
    panel.replaceChildren(
      make('button', { className: 'close', textContent: '×', title: 'close', onclick: () => ilot.select(null) }),
      make('h2', { textContent: unit.title }), make('table', {}, make('tbody', {}, ...rows)),
      make('div', { className: 'actions' }, ...actions));
    panel.hidden = false;
  }

  // Selects a unit everywhere: the panel, the plan and the view. `from` is where that was asked.
  ilot.select = async function (kind, id, element, from) {
    const unit = kind && finders[kind] ? await finders[kind](String(id), element === undefined ? undefined : String(element)) : null;
    ilot.selected = unit;
    document.getElementById('unit').hidden = !unit;
    if (unit) show(unit);
    const hash = unit ? '#' + [kind, encodeURIComponent(id), ...(element === undefined ? [] : [element])].join('/') : '#';
    if (location.hash !== hash && from !== 'link') history.replaceState(null, '', unit ? hash : location.pathname + location.search);
    document.dispatchEvent(new CustomEvent('ilot:selected', { detail: { unit, from } }));
    return unit;
  };

  ilot.follow = async function (first) {
    const parts = location.hash.slice(1).split('/').map((part) => { try { return decodeURIComponent(part); } catch { return part; } });
    if (parts[0] === 'facade' && parts[1]) {
      const sheet = document.getElementById('facade/' + parts[1]);
      if (sheet) sheet.open = true;
    }
    if (!finders[parts[0]] || parts.length < 2) return;
    const kind = parts[0], id = kind === 'building' ? parts.slice(1).join('/') : parts[1];
    const unit = await ilot.select(kind, id, kind === 'facade' ? parts[2] : undefined, 'link');
    if (unit && first) document.getElementById(kind === 'facade' && document.getElementById('facade/' + id) ? 'facade/' + id : 'view').scrollIntoView();
  };
}
