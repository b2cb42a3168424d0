// SPDX-License-Identifier: Apache-2.0
// What TU Delft's cityjson-threejs-loader reads in a CityJSON: `node cityjson_seen.mjs FILE` prints as JSON, for each object with a
// geometry, its type and parent and for each level of detail the area in square metres of the triangles of each kind of surface. It is
// looked up below ILOT_NPM.
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const source = join(process.env.ILOT_NPM ?? process.cwd(), 'node_modules/cityjson-threejs-loader/src/parsers/helpers/ChunkParser.js');
const {ChunkParser} = await import(pathToFileURL(source));
const model = JSON.parse(readFileSync(process.argv[2]));
const {scale} = model.transform;
const seen = {};
const parser = new ChunkParser();
parser.onchunkload = (vertices, data, lods, objectTypes, surfaces) => {
  const corner = i => [0, 1, 2].map(k => vertices[3 * i + k] * scale[k]);
  const ids = Object.keys(model.CityObjects), kinds = Object.keys(surfaces);
  for (let i = 0; data.geometryType === 2 && i < data.objectIds.length; i += 3) {
    const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
    const u = b.map((v, k) => v - a[k]), v = c.map((w, k) => w - a[k]);
    const area = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
    const id = ids[data.objectIds[i]], object = model.CityObjects[id];
    const levels = (seen[id] ??= {type: object.type, parents: object.parents ?? [], levels: {}}).levels;
    const level = levels[lods[data.lodIds[i]]] ??= {}, kind = kinds[data.semanticSurfaces[i]] ?? 'none';
    level[kind] = (level[kind] ?? 0) + area;
  }
};
parser.parse(model);
console.log(JSON.stringify(seen));
