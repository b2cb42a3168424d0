// SPDX-License-Identifier: Apache-2.0
// Bundles src/main.js with three.js into one script: node bundle.mjs OUTPUT
import { build } from 'esbuild';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
await build({
  entryPoints: [join(here, 'src', 'main.js')],
  outfile: process.argv[2] ?? join(here, 'viewer.js'),
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2020',
  charset: 'ascii',
  legalComments: 'inline',
  logLevel: 'warning',
});
