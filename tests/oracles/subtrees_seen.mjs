// SPDX-License-Identifier: Apache-2.0
// What NASA's 3d-tiles-renderer reads in the files of subtrees of a tileset: `node subtrees_seen.mjs FOLDER` prints its tiles as JSON,
// each with level, x, y, the box and the error that follow from the root, and its model. It is looked up below ILOT_NPM.
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const source = join(process.env.ILOT_NPM ?? process.cwd(), 'node_modules/3d-tiles-renderer/src/core/plugins/SUBTREELoader.js');
const {SUBTREELoader} = await import(pathToFileURL(source));
const folder = process.argv[2];
const root = JSON.parse(readFileSync(join(folder, 'tileset.json'))).root;
const seen = [];

async function expand(tile, uri) {
  const data = readFileSync(join(folder, uri));
  tile.children = [];
  await new SUBTREELoader(tile).parse(data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength));
  for (const child of tile.children) await note(child);
}

async function note(tile) {
  if (tile.content?.uri.endsWith('.subtree')) return expand(tile, tile.content.uri);
  const {level, x, y} = tile.implicitTilingData;
  seen.push({level, x, y, box: tile.boundingVolume.box, error: tile.geometricError, content: tile.content?.uri ?? null});
  for (const child of tile.children) await note(child);
}

root.implicitTilingData = {root, subtreeIdx: 0, x: 0, y: 0, z: 0, level: 0};
await expand(root, root.implicitTiling.subtrees.uri.replace('{level}', 0).replace('{x}', 0).replace('{y}', 0));
console.log(JSON.stringify(seen));
