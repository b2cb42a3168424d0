// SPDX-License-Identifier: Apache-2.0
// Reads a COPC file by npm's copc: `node copc_nodes.mjs IN.copc.laz` walks the whole hierarchy, decodes every node and
// prints how many nodes and points it found and how many points lie outside the cube of their node.
// copc is looked up below ILOT_NPM (a folder with node_modules).
import {createRequire} from 'node:module';
import {join} from 'node:path';

const require = createRequire(join(process.env.ILOT_NPM ?? process.cwd(), 'package.json'));
const {Copc} = require('copc');
const {createLazPerf} = require('laz-perf');
const input = process.argv[2];

async function allNodes(page) {
  const {nodes, pages} = await Copc.loadHierarchyPage(input, page);
  const lists = await Promise.all(Object.values(pages).map(allNodes));
  return lists.reduce((all, list) => all.concat(list), Object.entries(nodes));
}

function outsideOf(key, view, cube, slack) {
  const [level, ...cell] = key.split('-').map(Number);
  const edge = (cube[3] - cube[0]) / 2 ** level;
  let outside = 0;
  const axes = ['X', 'Y', 'Z'].map(name => view.getter(name));
  for (let i = 0; i < view.pointCount; ++i)
    outside += axes.some((get, axis) => {
      const from = cube[axis] + cell[axis] * edge, value = get(i);
      return value < from - slack || value > from + edge + slack;
    });
  return outside;
}

try {
  const lazPerf = await createLazPerf();
  const copc = await Copc.create(input);
  const nodes = await allNodes(copc.info.rootHierarchyPage);
  const found = {nodes: nodes.length, points: 0, outside: 0, declared: copc.header.pointCount, wkt: Boolean(copc.wkt)};
  for (const [key, node] of nodes) {
    const view = await Copc.loadPointDataView(input, copc, node, {lazPerf});
    found.points += view.pointCount;
    found.outside += outsideOf(key, view, copc.info.cube, copc.header.scale[0] / 1000);
  }
  console.log(`${found.nodes} ${found.points} ${found.outside} ${found.declared} ${found.wkt}`);
} catch (error) {
  console.error(`copc: ${error?.message ?? error}`);
  process.exit(3);
}
