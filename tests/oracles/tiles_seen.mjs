// SPDX-License-Identifier: Apache-2.0
// What Cesium's 3d-tiles-tools reads in a tileset: `node tiles_seen.mjs FOLDER` prints its tiles as JSON, each with level, box,
// geometric error, files of content and the subtree that begins there. 3d-tiles-tools is looked up below ILOT_NPM.
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

const require = createRequire(join(process.env.ILOT_NPM ?? process.cwd(), 'package.json'));
const {TilesetTraverser, FileResourceResolver} = require('3d-tiles-tools');
const folder = process.argv[2];
const tileset = JSON.parse(readFileSync(join(folder, 'tileset.json')));
const tiles = [];
const traverser = new TilesetTraverser(folder, new FileResourceResolver(folder), {depthFirst: true});
await traverser.traverse(tileset, async traversed => {
  if (traversed.isImplicitTilesetRoot()) return true;  // the root of all subtrees is its only child
  const tile = traversed.asFinalTile();
  tiles.push({level: traversed.level, box: tile.boundingVolume.box, error: tile.geometricError,
    contents: traversed.getFinalContents().map(content => content.uri), subtree: traversed.getSubtreeUri() ?? null});
  return true;
});
console.log(JSON.stringify(tiles));
