// SPDX-License-Identifier: Apache-2.0
// What Khronos' validator says of GLB files: `node gltf_faults.mjs FILE...` prints each error and warning, and ends with
// 1 where there is one. gltf-validator is looked up below ILOT_NPM (a folder with node_modules).
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

const require = createRequire(join(process.env.ILOT_NPM ?? process.cwd(), 'package.json'));
const validator = require('gltf-validator');
let faults = 0;
for (const path of process.argv.slice(2)) {
  const {issues} = await validator.validateBytes(new Uint8Array(readFileSync(path)), {maxIssues: 100});
  for (const {code, message, severity, pointer} of issues.messages) {
    if (severity > 1) continue;  // 0 error, 1 warning, 2 information, 3 hint
    console.log(`${path}: ${code} ${message} ${pointer ?? ''}`);
    ++faults;
  }
}
process.exit(faults > 0 ? 1 : 0);
