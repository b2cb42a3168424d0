// SPDX-License-Identifier: Apache-2.0
// `node tiles_browser.mjs CHROMIUM FOLDER PICTURE` draws FOLDER/3dtiles by NASA's 3d-tiles-renderer in headless Chromium,
// writes the picture, and prints as JSON what was drawn. esbuild and playwright-core are those of viewer/; three and
// 3d-tiles-renderer are looked up below ILOT_NPM.
import {createServer} from 'node:http';
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const require = createRequire(join(here, '../../viewer/package.json'));
const {chromium} = require('playwright-core');
const [browserPath, folder, picture] = process.argv.slice(2);

const bundle = await require('esbuild').build({
  entryPoints: [join(here, 'tiles_page.mjs')], bundle: true, format: 'esm', write: false, logLevel: 'error',
  nodePaths: [join(process.env.ILOT_NPM, 'node_modules')]});
const page_html = '<!doctype html><meta charset="utf-8"><style>body{margin:0}</style><script type="module" src="/page.js"></script>';
const server = createServer((request, response) => {
  const {pathname} = new URL(request.url, 'http://localhost');
  try {
    const [type, body] = pathname === '/' ? ['text/html', page_html]
      : pathname === '/page.js' ? ['text/javascript', bundle.outputFiles[0].contents]
      : ['application/octet-stream', readFileSync(join(folder, pathname))];
    response.writeHead(200, {'content-type': type}).end(body);
  } catch {
    response.writeHead(404).end();
  }
}).listen(0, '127.0.0.1');
await new Promise(done => server.once('listening', done));

const browser = await chromium.launch({executablePath: browserPath,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});
const page = await browser.newPage({viewport: {width: 1400, height: 900}});
const faults = [];
page.on('pageerror', fault => faults.push(String(fault)));
page.on('console', message => message.type() === 'error' && !/favicon|404/.test(message.text()) && faults.push(message.text()));
await page.goto(`http://127.0.0.1:${server.address().port}/`);
try {
  await page.waitForFunction(() => window.seen?.still && window.seen.triangles > 0, null, {timeout: 120000});
} catch (fault) {
  faults.push(String(fault));
}
await page.waitForTimeout(500);
const seen = JSON.parse(await page.evaluate(() => window.look?.() ?? '{}'));
await page.screenshot({path: picture});
await browser.close();
server.close();
console.log(JSON.stringify({...seen, faults: [...(seen.faults ?? []), ...faults]}));
