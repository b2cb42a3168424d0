// SPDX-License-Identifier: Apache-2.0
// Decodes LAZ files by npm's laz-perf: `node lazperf_decode.mjs IN.laz OUT.raw` writes the records of all points;
// with --time instead of OUT it prints points per second of the fastest of five rounds. Exit 3: cannot decode it.
// laz-perf is looked up below ILOT_NPM (a folder with node_modules).
import {createRequire} from 'node:module';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

const require = createRequire(join(process.env.ILOT_NPM ?? process.cwd(), 'package.json'));
const {createLazPerf} = require('laz-perf');
const [input, output] = process.argv.slice(2);
const bytes = readFileSync(input);
const lib = await createLazPerf();

// The records of all points; without `keep` they are decoded and dropped. Also how many there are.
function decode(keep) {
  const file = lib._malloc(bytes.length);
  lib.HEAPU8.set(bytes, file);
  const reader = new lib.LASZip();
  reader.open(file, bytes.length);
  const count = reader.getCount(), length = reader.getPointLength();
  const records = keep ? Buffer.alloc(count * length) : undefined;
  const point = lib._malloc(length);
  for (let i = 0; i < count; ++i) {
    reader.getPoint(point);
    records?.set(lib.HEAPU8.subarray(point, point + length), i * length);
  }
  reader.delete();
  lib._free(point);
  lib._free(file);
  return {count, records};
}

try {
  if (output === '--time') {
    const {count} = decode(false);
    let best = Infinity;
    for (let round = 0; round < 5; ++round) {
      const start = process.hrtime.bigint();
      decode(false);
      best = Math.min(best, Number(process.hrtime.bigint() - start) / 1e9);
    }
    console.log(Math.round(count / best));
  } else {
    writeFileSync(output, decode(true).records);
  }
} catch (error) {
  console.error(`laz-perf: ${error?.message ?? error}`);
  process.exit(3);
}
