#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`ilot export`: every format is read back by a reader that is not ilot's (export_readers.py, and below ILOT_NPM Khronos'
gltf-validator) and compared with the run's own CityJSON and facades. ILOT_EXE names the program."""
import json
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

import export_readers as readers
from export_support import KINDS, ROOT, must, npm_has, seen_in_ifc
from support import ilot

CRS = "EPSG:2154"  # that of scanned scenes
FORMATS = "glb,stl,ply,citygml,ifc,3dtiles"


class Exports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name)
        must("scan", "district", "-o", cls.folder / "d.laz", "--points", 150000, "-q")
        cls.out = cls.folder / "out"
        must("run", cls.folder / "d.laz", "-o", cls.out, "--products", "roofs", "--no-clouds", "-q", codes=(0, 3))
        cls.models = readers.city_models(cls.out / "roofs" / "roofs.city.jsonl")
        cls.solids = {name: levels[max(levels)] for name, (_, levels) in cls.models.items() if levels}
        assert len(cls.solids) > 5, "a district has buildings"
        cls.made = cls.folder / "made"
        cls.export = must("export", cls.out, "--to", FORMATS, "-o", cls.made, "--geoid-height", 43)

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def same_solid(self, triangles, solid, name, near):
        """Every corner is one of the solid's and none is missing, within `near`; closed; the same volume."""
        grid = lambda p: tuple(round(c / 0.05) for c in p)
        true = {}
        for p in solid.used():
            true.setdefault(grid(p), []).append(p)
        met = set()
        for p in {c for t in triangles for c in t}:
            cell = grid(p)
            best = min(((readers.length(readers.minus(p, q)), q) for dx in (-1, 0, 1) for dy in (-1, 0, 1) for dz in (-1, 0, 1)
                        for q in true.get((cell[0] + dx, cell[1] + dy, cell[2] + dz), [])), default=(9, None))
            self.assertLess(best[0], near, f"{name}: {p}")
            met.add(best[1])
        self.assertEqual(len(met), len(solid.used()), name)
        self.assertEqual(readers.mesh_faults(triangles), 0, f"{name} is not closed")
        volume = solid.volume()
        self.assertGreater(volume, 0)
        self.assertLess(abs(readers.mesh_volume(triangles) / volume - 1), 1e-3, name)

    def test_glb(self):
        glb = readers.Glb((self.made / "roofs.glb").read_bytes())
        root = glb.json["nodes"][0]
        self.assertEqual(root["extras"]["offset"], glb.json["asset"]["extras"]["offset"])
        found = {}
        for node, primitives in glb.meshes():
            found[node["name"]] = primitives
            attributes = self.models[node["name"]][0]
            self.assertEqual(node["extras"]["status"], attributes["status"])
            self.assertEqual(node["extras"]["points"], attributes["points"])
        self.assertEqual(set(found), set(self.solids))
        for name, primitives in found.items():
            solid = self.solids[name]
            z_up = [tuple((x, -z, y) for x, y, z in t) for p in primitives for t in p["triangles"]]
            self.same_solid(z_up, solid, name, 0.001)
            kinds = {glb.json["materials"][p["material"]]["name"] for p in primitives}
            self.assertEqual(kinds, {k[:-len("Surface")].lower() for k in solid.kinds})
            for p in primitives:
                for t, corners in zip(p["triangles"], p["corners"]):
                    turn = readers.cross(readers.minus(t[1], t[0]), readers.minus(t[2], t[0]))
                    if readers.length(turn) < 1e-3:
                        continue
                    normal = readers.turned(root["rotation"], p["attributes"]["NORMAL"][corners[0]])
                    self.assertGreater(readers.dot(turn, normal) / readers.length(turn), 0.99)

    def test_stl(self):
        offset, triangles = readers.read_stl(self.made / "roofs.stl")
        self.assertEqual(readers.mesh_faults(triangles), 0)
        full = [tuple(tuple(c + o for c, o in zip(p, offset)) for p in t) for t in triangles]
        self.assertLess(abs(readers.mesh_volume(triangles) / sum(s.volume() for s in self.solids.values()) - 1), 1e-3)
        corners = {tuple(round(c, 2) for c in p) for t in full for p in t}
        for solid in self.solids.values():
            for p in solid.used():
                near = {tuple(round(c + d, 2) for c, d in zip(p, (dx, dy, dz))) for dx in (-.002, .002) for dy in (-.002, .002)
                        for dz in (-.002, .002)}
                self.assertTrue(near & corners, f"{p} is no corner of the STL")

    def test_ply(self):
        lines, vertices, faces = readers.read_ply(self.made / "roofs.ply")
        self.assertIn("property double x", lines)
        names = list(self.models)
        for name, solid in self.solids.items():
            mine = [(t, k) for t, k, b in faces if b == names.index(name) + 1]
            self.same_solid([tuple(vertices[i] for i in t) for t, _ in mine], solid, name, 1e-5)
            self.assertEqual(readers.mesh_faults([t for t, _ in mine]), 0, "closed by the numbers of its vertices")
            self.assertEqual({KINDS[k] for _, k in mine}, set(solid.kinds))

    def on_earth(self, places):
        """GDAL's own program, where the test lets PROJ work apart from ilot."""
        text = "".join(f"{x!r} {y!r} {z + 43!r}\n" for x, y, z in places)
        done = subprocess.run(["gdaltransform", "-s_srs", CRS, "-t_srs", "EPSG:4978"], input=text, capture_output=True, text=True, check=True)
        return [tuple(map(float, line.split())) for line in done.stdout.splitlines()]

    def test_tiles(self):
        tileset = readers.read_tileset(self.made / "3dtiles")
        self.assertEqual(tileset["asset"]["version"], "1.1")
        root = tileset["root"]
        shown = {}
        self.walk(root, tileset["geometricError"], None, shown)
        self.assertEqual(set(shown), set(self.solids))
        matrix = root["transform"]
        earth = lambda p: tuple(sum(matrix[4 * k + i] * p[k] for k in range(3)) + matrix[12 + i] for i in range(3))
        for name, triangles in shown.items():
            solid = self.solids[name]
            placed = dict(zip(sorted(solid.used()), self.on_earth(sorted(solid.used()))))
            there = readers.Solid([placed.get(v, v) for v in solid.vertices], solid.faces, solid.kinds)
            self.same_solid([tuple(map(earth, t)) for t in triangles], there, name, 0.001)

    def walk(self, tile, error, outer, shown):
        """Boxes lie in those above, errors never grow, and each building is in one tile."""
        box = tile["boundingVolume"]["box"]
        half = (box[3], box[7], box[11])
        bounds = [(m - h, m + h) for m, h in zip(box, half)]
        if outer:
            for (low, high), (least, most) in zip(bounds, outer):
                self.assertTrue(least - 0.02 <= low <= high <= most + 0.02, "a tile leaves that above it")
        self.assertLessEqual(tile["geometricError"], error)
        if "children" not in tile:
            self.assertEqual(tile["geometricError"], 0)
        if "content" in tile:
            glb = readers.Glb((self.made / "3dtiles" / tile["content"]["uri"]).read_bytes())
            for name, triangles in self.features(glb).items():
                self.assertNotIn(name, shown)
                shown[name] = triangles
                for p in (p for t in triangles for p in t):
                    self.assertTrue(all(low <= c <= high for c, (low, high) in zip(p, bounds)), "a corner leaves its tile")
        for child in tile.get("children", []):
            self.walk(child, tile["geometricError"], bounds, shown)

    def features(self, glb):
        """id -> triangles, by the features of vertices and the tables of metadata; what tables say is compared."""
        tables = [readers.property_table(glb, t) for t in glb.json["extensions"]["EXT_structural_metadata"]["propertyTables"]]
        self.assertEqual([t["name"] for t in tables], ["building", "face"])
        buildings, faces = tables
        for name, points, height in zip(buildings["id"], buildings["points"], buildings["h_roof_max"]):
            attributes = self.models[name][0]
            self.assertEqual(points, attributes["points"])
            self.assertAlmostEqual(height, attributes["h_roof_max"])
        for name in buildings["id"]:
            mine = [KINDS[s] for s, b in zip(faces["surface"], faces["building"]) if b == name]
            self.assertEqual(mine, self.solids[name].kinds)
        found = {}
        for _, primitives in glb.meshes():
            for p in primitives:
                ids = p["extensions"]["EXT_mesh_features"]["featureIds"]
                self.assertEqual([(i["attribute"], i["propertyTable"], i["featureCount"]) for i in ids],
                                 [(0, 0, len(buildings["id"])), (1, 1, len(faces["building"]))])
                for t, corners in zip(p["triangles"], p["corners"]):
                    building, face = ({int(p["attributes"][f"_FEATURE_ID_{k}"][c]) for c in corners} for k in (0, 1))
                    self.assertEqual((len(building), len(face)), (1, 1))
                    name, number = buildings["id"][building.pop()], face.pop()
                    self.assertEqual(faces["building"][number], name)
                    self.assertEqual(faces["surface"][number], p["material"])
                    found.setdefault(name, []).append(tuple((x, -z, y) for x, y, z in t))
        return found

    def test_citygml(self):
        """By an XML reader alone: names are in the order of the schema, and coordinates are those of the CityJSON."""
        namespaces = {"c": "http://www.opengis.net/citygml/2.0", "b": "http://www.opengis.net/citygml/building/2.0",
                      "g": "http://www.opengis.net/gml", "n": "http://www.opengis.net/citygml/generics/2.0"}
        tree = xml.etree.ElementTree.parse(self.made / "roofs.gml").getroot()
        buildings = tree.findall("c:cityObjectMember/b:Building", namespaces)
        self.assertEqual([b.find("g:name", namespaces).text for b in buildings], list(self.models))
        for building in buildings:
            name = building.find("g:name", namespaces).text
            attributes, levels = self.models[name]
            told = {a.get("name"): a[0].text for a in building if a.tag.startswith("{" + namespaces["n"])}
            self.assertEqual(told["status"], attributes["status"])
            self.assertEqual(int(told["points"]), attributes["points"])
            tags = [child.tag.split("}")[1] for child in building]
            order = ["name", "stringAttribute", "intAttribute", "doubleAttribute", "lod0FootPrint", "lod1Solid", "lod2Solid", "boundedBy"]
            first_geometry = next(i for i, tag in enumerate(tags) if tag.startswith("lod"))
            self.assertEqual(tags[first_geometry:], sorted(tags[first_geometry:], key=order.index))
            rings = lambda polygon: [[tuple(map(float, words)) for words in zip(*[iter(ring.text.split())] * 3)]
                                     for ring in polygon.iter("{" + namespaces["g"] + "}posList")]
            for lod, solid in levels.items():
                if lod == "1.3":
                    continue  # CityGML has one place for LoD1, which LoD1.2 takes
                true = [[[solid.vertices[i] for i in ring] for ring in face] for face in solid.faces]
                if lod.startswith("2"):
                    surfaces = [s[0] for s in building.findall("b:boundedBy", namespaces)]
                    self.assertEqual([s.tag.split("}")[1] for s in surfaces], solid.kinds)
                    polygons = [p for s in surfaces for p in s.iter("{" + namespaces["g"] + "}Polygon")]
                    ids = ["#" + p.get("{" + namespaces["g"] + "}id") for p in polygons]
                    members = building.find("b:lod2Solid", namespaces).iter("{" + namespaces["g"] + "}surfaceMember")
                    self.assertEqual([m.get("{http://www.w3.org/1999/xlink}href") for m in members], ids)
                else:
                    polygons = list(building.find("b:lod1Solid", namespaces).iter("{" + namespaces["g"] + "}Polygon"))
                self.assertEqual(len(polygons), len(true))
                for polygon, face in zip(polygons, true):
                    for ring, corners in zip(rings(polygon), face, strict=True):
                        self.assertEqual(ring[0], ring[-1])
                        for p, q in zip(ring[:-1], corners, strict=True):
                            self.assertLess(readers.length(readers.minus(p, q)), 1e-4)

    @unittest.skipUnless(npm_has("ogc-schemas") and npm_has("jsonix"), "no node, or no ogc-schemas and jsonix below ILOT_NPM")
    def test_citygml_by_the_schemas(self):
        """Every element is where OGC's schemas have it; one that they do not know is refused."""
        def read(path):
            return subprocess.run(["node", ROOT / "tests/oracles/citygml_seen.mjs", path], capture_output=True, text=True)
        seen = read(self.made / "roofs.gml")
        self.assertEqual(seen.returncode, 0, seen.stderr)
        for kind in ("BuildingType", "RoofSurfaceType", "WallSurfaceType", "GroundSurfaceType"):
            self.assertGreater(json.loads(seen.stdout)["CityGML_Building_2_0." + kind], 0)
        wrong = self.folder / "wrong.gml"
        wrong.write_text((self.made / "roofs.gml").read_text().replace("bldg:RoofSurface", "bldg:RoofTop", 2))  # of the first building
        self.assertIn("RoofTop", read(wrong).stderr)

    def test_citygml_in_gdal(self):
        copy = self.folder / "copy.gml"  # GDAL writes a file beside it
        shutil.copy(self.made / "roofs.gml", copy)
        done = subprocess.run(["ogrinfo", "-ro", "-so", "-al", copy], capture_output=True, text=True, check=True)
        self.assertIn("Layer name: Building\n", done.stdout)
        self.assertIn(f"Feature Count: {len(self.models)}\n", done.stdout)
        self.assertIn(f'ID["EPSG",{CRS[5:]}]', done.stdout)

    def test_citygml_with_north_before_east(self):
        """Where EPSG's own order is north before east, coordinates stay east before north."""
        north = self.folder / "north"
        must("export", self.out, "--to", "citygml", "-o", north, "--crs", "EPSG:3006")
        low = [min(p[axis] for s in self.solids.values() for p in s.used()) for axis in range(2)]
        done = subprocess.run(["ogrinfo", "-ro", "-so", "-al", "--config", "GML_SKIP_RESOLVE_ELEMS", "NONE",
                               north / "roofs.gml"], capture_output=True, text=True, check=True)
        extent = re.search(r"Extent: \(([\d.]+), ([\d.]+)\)", done.stdout)
        for axis in range(2):
            self.assertAlmostEqual(float(extent[axis + 1]), low[axis], delta=200)

    def test_tiles_in_feet(self):
        """Heights in feet of a system without heights of its own are metres on the earth."""
        feet, there = self.folder / "feet", self.folder / "there"
        shutil.copytree(self.out, feet)
        run = json.loads((feet / "run.json").read_text())
        run["crs"].update({"name": "EPSG:2263", "metres_per_unit": 0.3048006096012192})
        (feet / "run.json").write_text(json.dumps(run))
        must("export", feet, "--to", "3dtiles", "-o", there)
        box = json.loads((there / "3dtiles" / "tileset.json").read_text())["root"]["boundingVolume"]["box"]
        heights = [p[2] for s in self.solids.values() for p in s.used()]
        self.assertAlmostEqual(2 * box[11], 0.3048006 * (max(heights) - min(heights)), delta=0.5)

    def test_plan_and_heights_from_two_systems(self):
        """A CRS without one code keeps its heights: those above the geoid EGM96 become heights above the ellipsoid."""
        pair, there = self.folder / "pair", self.folder / "pair_tiles"
        must("run", self.folder / "d.laz", "-o", pair, "--products", "roofs", "--no-clouds", "--no-report", "-q", "--crs", "EPSG:2154+5773",
             codes=(0, 3))
        self.assertIn("EGM96 height", json.loads((pair / "run.json").read_text())["crs"]["wkt"])
        must("export", pair, "--to", "3dtiles", "-o", there)
        tileset = json.loads((there / "3dtiles" / "tileset.json").read_text())
        x, y, z = tileset["asset"]["extras"]["ilot"]["origin"]
        done = subprocess.run(["gdaltransform", "-s_srs", "EPSG:2154+5773", "-t_srs", "EPSG:4978"], input=f"{x} {y} {z}\n",
                              capture_output=True, text=True, check=True)
        for found, true in zip(tileset["root"]["transform"][12:15], map(float, done.stdout.split())):
            self.assertAlmostEqual(found, true, delta=0.01)

    def test_ifc_of_nothing(self):
        """A run of facades that found none: there is nothing to write, and it says so."""
        bare = self.folder / "bare"
        shutil.copytree(self.out, bare)
        run = json.loads((bare / "run.json").read_text())
        run["products"] = ["facades"]
        run["results"] = [r for r in run["results"] if not r["path"].startswith("roofs/")]
        (bare / "run.json").write_text(json.dumps(run))
        self.refuse([bare, "--to", "ifc", "-o", self.folder / "bare_ifc"], "neither a roof nor a facade")

    def test_a_folder_of_the_user_stays(self):
        mine = self.folder / "keep.part"
        mine.mkdir()
        (mine / "precious").write_text("mine")
        must("export", self.out, "--to", "ply", "-o", self.folder / "keep")
        self.assertEqual((mine / "precious").read_text(), "mine")
        self.assertTrue((self.folder / "keep" / "roofs.ply").exists())
        self.assertFalse((self.folder / "keep.part2").exists())

    @unittest.skipUnless(npm_has("web-ifc"), "no node, or no web-ifc below ILOT_NPM")
    def test_ifc(self):
        """web-ifc finds each envelope where CityJSON has it, as large and with its attributes."""
        read = seen_in_ifc(self.made / "roofs.ifc")
        self.assertEqual((read["schema"], read["crs"]), ("IFC4X3_ADD2", CRS))
        envelopes = {e["name"]: e for e in read["elements"] if e["type"] == "IfcBuildingElementProxy"}
        self.assertEqual(set(envelopes), set(self.solids))
        for building in (e for e in read["elements"] if e["type"] == "IfcBuilding"):
            self.assertEqual(building["properties"]["ilot_Building"]["points"], self.models[building["name"]][0]["points"])
        for name, solid in self.solids.items():
            mesh = envelopes[name]["mesh"]
            self.assertAlmostEqual(mesh["volume"] / solid.volume(), 1, delta=1e-3)
            for axis in range(3):
                self.assertAlmostEqual(mesh["low"][axis] + read["map"][axis], min(p[axis] for p in solid.used()), delta=0.001)
                self.assertAlmostEqual(mesh["high"][axis] + read["map"][axis], max(p[axis] for p in solid.used()), delta=0.001)

    def test_unknown_crs(self):
        plain, nowhere = self.folder / "plain", self.folder / "nowhere"
        shutil.copytree(self.out, nowhere)
        run = json.loads((nowhere / "run.json").read_text())
        run["crs"]["name"] = "none"
        (nowhere / "run.json").write_text(json.dumps(run))
        done = must("export", nowhere, "--to", "3dtiles", "-o", plain)
        self.assertIn("not placed on the earth", done.stderr)
        tileset = json.loads((plain / "3dtiles" / "tileset.json").read_text())
        self.assertNotIn("transform", tileset["root"])
        self.assertIn("unknown", tileset["asset"]["extras"]["ilot"]["placed"])
        shown = {}
        for tile in (plain / "3dtiles" / "tiles").iterdir():
            shown.update(self.features(readers.Glb(tile.read_bytes())))
        offset = tileset["asset"]["extras"]["ilot"]["origin"]
        for name, solid in self.solids.items():
            full = [tuple(tuple(c + o for c, o in zip(p, offset)) for p in t) for t in shown[name]]
            self.same_solid(full, solid, name, 0.001)

    def test_validator(self):
        if not npm_has("gltf-validator"):
            self.skipTest("no node, or no gltf-validator below ILOT_NPM")
        done = subprocess.run(["node", ROOT / "tests/oracles/gltf_faults.mjs", *self.made.rglob("*.glb")], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)

    def test_same_bytes(self):
        again = self.folder / "again"
        must("export", self.out, "--to", FORMATS, "-o", again, "--geoid-height", 43)
        files = sorted(p.relative_to(self.made) for p in self.made.rglob("*") if p.is_file())
        self.assertEqual(files, sorted(p.relative_to(again) for p in again.rglob("*") if p.is_file()))
        for file in files:
            self.assertEqual((self.made / file).read_bytes(), (again / file).read_bytes(), file)

    def refuse(self, arguments, *words, code=2):
        before = sorted(self.folder.rglob("*"))
        done = ilot("export", *arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before, "nothing may be written")

    def test_bad_input(self):
        new = self.folder / "new"
        self.refuse([], "no OUT given")
        self.refuse([self.out, "-o", new], "--to FORMAT is needed")
        self.refuse([self.out, "--to", "glb"], "-o FOLDER is needed")
        self.refuse([self.out, "--to", "gbl", "-o", new], "gbl", "glb")
        self.refuse([self.folder, "--to", "glb", "-o", new], "no run.json")
        self.refuse([self.out, "--to", "glb", "-o", self.made], "there already")
        self.refuse([self.out, "--to", "glb", "-o", self.out], "there already")
        self.refuse([self.out, "--to", "glb", "-o", new, "--crs", "EPSG:999999"], "EPSG:999999")
        self.refuse([self.out, "--to", "ply", "-o", new, "--crs", "rubbish"], "rubbish")
        self.refuse([self.out, "--to", "ply", "-o", new, "--crs", "EPSG:4326"], "EPSG:4326", "plane coordinates")
        self.refuse([self.out, "--to", "ply", "-o", new, "--crs", "EPSG:2263"], "EPSG:2263", "unit")
        broken = self.folder / "broken"
        shutil.copytree(self.out, broken)
        file = broken / "roofs" / "roofs.city.jsonl"
        file.write_bytes(file.read_bytes()[:-200])
        self.refuse([broken, "--to", "glb,stl,ply", "-o", new], "roofs.city.jsonl:", code=1)


if __name__ == "__main__":
    unittest.main()
