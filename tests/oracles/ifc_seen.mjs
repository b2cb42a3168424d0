// SPDX-License-Identifier: Apache-2.0
// `node ifc_seen.mjs FILE.ifc` reads an IFC file by npm's web-ifc and prints as JSON what is in it: elements with names,
// sizes, properties, and the boxes and volumes of their geometry, in metres with z up. Voids are cut by web-ifc.
// web-ifc is looked up below ILOT_NPM (a folder with node_modules).
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

const require = createRequire(join(process.env.ILOT_NPM ?? process.cwd(), 'package.json'));
const W = require('web-ifc');
const api = new W.IfcAPI();
await api.Init();
api.SetLogLevel(W.LogLevel?.LOG_LEVEL_OFF ?? 6);
const model = api.OpenModel(new Uint8Array(readFileSync(process.argv[2])), {COORDINATE_TO_ORIGIN: false});
const list = type => { const ids = api.GetLineIDsWithType(model, type); return Array.from({length: ids.size()}, (_, i) => ids.get(i)); };
const value = v => v && typeof v === 'object' && 'value' in v ? v.value : v;

const properties = new Map();
for (const id of list(W.IFCRELDEFINESBYPROPERTIES)) {
  const relation = api.GetLine(model, id);
  const set = api.GetLine(model, value(relation.RelatingPropertyDefinition));
  for (const element of relation.RelatedObjects) {
    const all = properties.get(value(element)) ?? {};
    all[value(set.Name)] = Object.fromEntries(set.HasProperties.map(p => api.GetLine(model, value(p)))
      .map(p => [value(p.Name), value(p.NominalValue)]));
    properties.set(value(element), all);
  }
}

function mesh_of(id) {
  const mesh = api.GetFlatMesh(model, id);
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const triangles = [];
  for (let i = 0; i < mesh.geometries.size(); ++i) {
    const placed = mesh.geometries.get(i), m = placed.flatTransformation;
    const geometry = api.GetGeometry(model, placed.geometryExpressID);
    const vertices = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
    const indices = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
    const corner = k => {
      const [x, y, z] = vertices.slice(6 * k, 6 * k + 3);
      const p = [0, 1, 2].map(r => m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r]);
      return [p[0], -p[2], p[1]];  // y up to z up
    };
    for (let k = 0; k < indices.length; k += 3) triangles.push([0, 1, 2].map(c => corner(indices[k + c])));
  }
  for (const t of triangles) for (const p of t) for (let r = 0; r < 3; ++r) {
    low[r] = Math.min(low[r], p[r]);
    high[r] = Math.max(high[r], p[r]);
  }
  const from = low, minus = (a, b) => a.map((c, r) => c - b[r]);
  const volume = triangles.reduce((sum, t) => {
    const [a, b, c] = t.map(p => minus(p, from));
    return sum + (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }, 0);
  return {triangles: triangles.length, low, high, volume: Math.abs(volume)};
}

const told = {schema: api.GetModelSchema(model), elements: []};
for (const [type, code] of Object.entries({IfcWall: W.IFCWALL, IfcWindow: W.IFCWINDOW, IfcDoor: W.IFCDOOR, IfcOpeningElement: W.IFCOPENINGELEMENT,
                                           IfcBuildingElementProxy: W.IFCBUILDINGELEMENTPROXY, IfcBuilding: W.IFCBUILDING}))
  for (const id of list(code)) {
    const line = api.GetLine(model, id);
    told.elements.push({type, id, guid: value(line.GlobalId), name: value(line.Name), width: value(line.OverallWidth), height: value(line.OverallHeight),
                        properties: properties.get(id) ?? {}, mesh: type === 'IfcBuilding' ? null : mesh_of(id)});
  }
for (const [name, code, from, to] of [['voids', W.IFCRELVOIDSELEMENT, 'RelatingBuildingElement', 'RelatedOpeningElement'],
                                      ['fills', W.IFCRELFILLSELEMENT, 'RelatingOpeningElement', 'RelatedBuildingElement']])
  told[name] = list(code).map(id => api.GetLine(model, id)).map(r => [value(r[from]), value(r[to])]);
told.map = list(W.IFCMAPCONVERSION).map(id => api.GetLine(model, id))
  .map(m => [value(m.Eastings), value(m.Northings), value(m.OrthogonalHeight)])[0] ?? null;
told.crs = list(W.IFCPROJECTEDCRS).map(id => value(api.GetLine(model, id).Name))[0] ?? null;
process.stdout.write(JSON.stringify(told) + '\n', () => process.exit(0));
