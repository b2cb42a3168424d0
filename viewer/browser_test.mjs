// SPDX-License-Identifier: Apache-2.0
// Opens reports in a browser and looks at them: node browser_test.mjs BROWSER PICTURES REPORT..., each a file or an address of
// ilot view.
// For each report: no error on the console, no request but of its own files, the view has a picture, a click on each kind of
// unit in the view and in the plan shows that unit, the theme changes, and paper has pictures. Writes a picture of each
// section, light and dark, and a PDF. Times are printed and not bounded: WebGL may be software here.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [, , executablePath, pictures, ...reports] = process.argv;
const args = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];

// How many colours a picture of the view has, and which part of it is not background.
const lookAtView = () => {
  const { canvas, renderer } = window.ilot.viewer.view;
  window.ilot.viewer.view.draw();
  const gl = renderer.getContext(), bytes = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  const words = new Uint32Array(bytes.buffer), background = words[0];
  return { colours: new Set(words).size, drawn: words.reduce((n, word) => n + (word !== background), 0) / words.length, background };
};

async function clickInView(page, kind, id) {
  await page.evaluate((k) => window.ilot.select(...k).then(() => window.ilot.viewer.settled), [kind, id]);  // the view goes there
  const [x, y] = await page.evaluate((k) => window.ilot.viewer.onScreen(...k), [kind, id]);
  await page.evaluate(() => window.ilot.select(null));
  await page.locator('#viewer canvas').click({ position: { x, y } });
  await page.waitForTimeout(300);
  return page.evaluate(() => window.ilot.selected && [window.ilot.selected.kind, String(window.ilot.selected.id)]);
}

// Only this layer is shown, so that what a click meets is known.
const showOnly = (page, name) => page.evaluate((only) => {
  const { shown, tools } = window.ilot.viewer;
  for (const layer of Object.keys(tools.toggles)) if (shown[layer] !== (layer === only)) tools.toggle(layer);
}, name);

async function checkView(page, data) {
  const light = await page.evaluate(lookAtView);
  assert.ok(light.colours > 20, `the view has only ${light.colours} colours`);
  assert.ok(light.drawn > 0.01, `the view shows nothing (${light.drawn})`);
  const units = { buildings: ['building', data.building], facades: ['facade', data.facade], objects: ['object', data.object] };
  for (const [layer, [kind, id]] of Object.entries(units)) {
    if (id === undefined) continue;
    await showOnly(page, layer);
    const got = await clickInView(page, kind, id);
    assert.deepEqual(got, [kind, String(id)], `a click on ${kind} ${id}`);
    assert.match(await page.locator('#unit h2').textContent(), new RegExp(String(id).replace(/[^\w]/g, '.')));
  }
  if (data.planes.length > 2) {  // one may be behind another, or its middle a hole: most of them are hit
    await showOnly(page, 'planes');
    let hits = 0;
    for (const id of data.planes) hits += String((await clickInView(page, 'plane', id))?.[1]) === String(id);
    assert.ok(2 * hits > data.planes.length, `${hits} of ${data.planes.length} planes answer to a click`);
  }
  await showOnly(page, 'points');
  await page.evaluate(() => window.ilot.select(null));
  await page.locator('#viewer select').last().selectOption('level');
  const cut = await page.evaluate(lookAtView);
  assert.ok(cut.drawn < light.drawn || light.drawn > 0.9, 'a section leaves something out');
  await page.locator('#viewer select').last().selectOption('off');
  await page.locator('#viewer canvas').focus();
  for (const key of ['t', 'm', 'm', 'c', 'h', '+', '-', 'ArrowLeft', 'x', 'x', 'x', 'x', 'x', '?', '?', 'p', 'p']) await page.keyboard.press(key);
  await page.evaluate(() => {
    const t = window.ilot.viewer.tools;
    for (const layer of Object.keys(t.toggles)) if (layer !== 'planes' && !window.ilot.viewer.shown[layer]) t.toggle(layer);
  });
}

async function checkPlan(page, data) {
  if (data.building === undefined) return;
  await page.evaluate((id) => window.ilot.select('building', id), data.building);
  await page.waitForTimeout(200);
  const [x, y] = await page.evaluate((id) => {
    const { plan } = window.ilot;
    Object.assign(plan.shown, { walls: false, objects: false });  // which lie above buildings
    const b = plan.layers.buildings.find((one) => one.id === id);
    // A place that is surely inside: of a raster over the box, the one that the plan itself finds inside by its rings.
    for (let i = 1; i < 60; ++i) for (let k = 1; k < 60; ++k) {
      const at = [b.box[0] + ((b.box[2] - b.box[0]) * i) / 60, b.box[1] + ((b.box[3] - b.box[1]) * k) / 60], px = plan.x(at[0]), py = plan.y(at[1]);
      const found = plan.unitAt(px, py);
      if (found && found[0] === 'building' && found[1] === id) return [px, py];
    }
    return [-1, -1];
  }, data.building);
  assert.ok(x >= 0, 'the plan shows the building');
  await page.evaluate(() => window.ilot.select(null));
  await page.locator('.plan canvas').click({ position: { x, y } });
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => window.ilot.selected?.id), data.building);
}

const dataOf = (page) => page.evaluate(async () => {
  const { ilot } = window, [buildings, facades, street, planes, scene] = await Promise.all(['buildings', 'facades', 'street', 'planes', 'scene'].map((n) => ilot.json(n)));
  const best = (list, value) => list.reduce((a, b) => (value(b) > value(a) ? b : a), list[0]);
  const solid = buildings?.id.map((id, i) => i).filter((i) => buildings.faces[i] > 0);
  return {
    viewer: Boolean(ilot.viewer), points: scene.points.count,
    building: solid?.length ? buildings.id[best(solid, (i) => -Math.abs(buildings.faces[i] - 2) * 1e6 + buildings.area_dm2[i])] : undefined,
    facade: facades?.length ? facades[0].id : undefined,
    object: street?.objects.length ? best(street.objects, (o) => o[7] * o[8] * o[6])[0] : undefined,
    planes: (planes?.id ?? []).filter((id, i) =>
      planes.area_dm2[i] > 500 && planes.area_dm2[i] < 10000 && planes.normal_e4[3 * i + 2] > 5000 && planes.confidence_pm[i] > 800).slice(0, 5),
  };
});

// What is compared with another result, and with the truth, says something.
async function checkComparisons(page) {
  const text = (id) => page.evaluate((i) => document.getElementById(i)?.innerText ?? null, id);
  const against = await text('against'), truth = await text('truth');
  if (against !== null) assert.match(against, /roofs\.detail/, 'the setting that differs is named');
  if (truth !== null) {
    assert.ok(await page.locator('#truth table').count() > 1, 'tables against the truth');
    assert.doesNotMatch(truth, /nan|undefined/i);
  }
  return [against, truth].filter((one) => one !== null).length;
}

async function checkReport(browser, path) {
  const served = /^http:/.test(path), address = served ? path : pathToFileURL(resolve(path)).href;
  const name = served ? 'served' : basename(dirname(resolve(path)));
  const context = await browser.newContext({ viewport: { width: 1200, height: 820 }, colorScheme: 'light' });
  const page = await context.newPage(), problems = [];
  page.setDefaultTimeout(180000);
  page.on('console', (message) => { if (['error', 'warning'].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text())) problems.push(message.text()); });
  page.on('pageerror', (error) => problems.push(error.stack));
  const own = (url) => /^(file|data|blob):/.test(url) || (served && url.startsWith(new URL(address).origin));
  page.on('request', (request) => { if (!own(request.url())) problems.push('asks for ' + request.url()); });
  const began = Date.now();
  await page.goto(address);
  await page.evaluate(() => window.ilot.started);
  console.log(`${name}: first picture after ${Date.now() - began} ms${served ? '' : `, ${readFileSync(path).length} bytes`}`);
  const data = await dataOf(page);
  assert.ok(data.viewer, 'this ilot was built without its viewer');
  const sections = await page.locator('main > section').evaluateAll((list) => list.map((s) => s.id));
  for (const theme of ['light', 'dark']) {
    await page.evaluate((t) => { document.documentElement.dataset.theme = t; document.dispatchEvent(new CustomEvent('ilot:theme')); }, theme);
    for (const section of sections) {
      await page.evaluate((id) => document.getElementById(id).scrollIntoView(), section);
      await page.waitForTimeout(100);
      await page.screenshot({ path: join(pictures, `${name}-${section}-${theme}.png`) });
    }
    const { background } = await page.evaluate(lookAtView);
    assert.equal((background & 255) < 128, theme === 'dark', `the view's background in ${theme}`);
  }
  await page.evaluate(() => { document.documentElement.dataset.theme = 'light'; document.dispatchEvent(new CustomEvent('ilot:theme')); });
  if (data.points > 0) await checkView(page, data);
  await checkPlan(page, data);
  const comparisons = await checkComparisons(page);
  if (comparisons > 0) console.log(`${name}: ${comparisons} comparisons`);
  await page.pdf({ path: join(pictures, `${name}.pdf`), preferCSSPageSize: true, printBackground: true });
  assert.equal(await page.locator('img.on-paper').count(), 0, 'after printing the page is as before');
  if (data.building !== undefined) {  // a link of its own
    const other = await context.newPage();
    await other.goto(address + '#building/' + encodeURIComponent(data.building));
    await other.evaluate(() => window.ilot.started);
    assert.equal(await other.locator('#unit h2').textContent(), 'Building ' + data.building);
  }
  assert.deepEqual(problems, []);
  await context.close();
}

const browser = await chromium.launch({ executablePath, args });
try {
  for (const report of reports) await checkReport(browser, report);
} finally {
  await browser.close();
}
console.log(`${reports.length} reports looked at; pictures in ${pictures}`);
