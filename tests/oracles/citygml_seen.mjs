// SPDX-License-Identifier: Apache-2.0
// Reads a CityGML 2.0 file with what npm's ogc-schemas made of OGC's XML schemas: `node citygml_seen.mjs FILE` prints how
// many values of each type of the schemas the last building has; all are read. An element at a place where they know none ends it with a fault; attributes, the
// order and the number of elements are not checked. jsonix, ogc-schemas and w3c-schemas are looked up below ILOT_NPM.
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

const require = createRequire(join(process.env.ILOT_NPM ?? process.cwd(), 'package.json'));
const {Jsonix} = require('jsonix');
const schemas = {...require('w3c-schemas'), ...require('ogc-schemas')};
const names = ['XLink_1_0', 'SMIL_2_0_Language', 'SMIL_2_0', 'xAL_2_0', 'GML_3_1_1', 'CityGML_2_0', 'CityGML_Building_2_0', 'CityGML_Generics_2_0'];
const context = new Jsonix.Context(names.map(name => schemas[name]));
const read = context.createUnmarshaller().unmarshalString(readFileSync(process.argv[2], 'utf8'));
const counts = {};
function count(value) {
  if (!value || typeof value !== 'object') return;
  if (value.TYPE_NAME) counts[value.TYPE_NAME] = (counts[value.TYPE_NAME] ?? 0) + 1;
  Object.values(value).forEach(count);
}
count(read.value);
console.log(JSON.stringify(counts));
