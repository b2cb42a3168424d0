#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every file of a small run of four products and of its exports is opened by a reader that is not ilot's (docs/readers.md), and must
hold as much as run.json says. A kind of file that no test reads is a fault. ILOT_EXE names the program."""
import collections
import csv
import html.parser
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
from drawing_test import AUDIT, python_with_ezdxf
from export_support import ROOT, must, npm_has, seen_in_ifc

CRS = "EPSG:2154"  # that of scanned scenes
READ = {".laz", ".copc.laz", ".gpkg", ".tif", ".png", ".pgw", ".dxf", ".json", ".jsonl", ".obj", ".mtl", ".stl", ".csv", ".svg", ".pdf",
        ".html", ".gml", ".glb", ".ifc", ".ply", ".subtree"}
MESHES = """
import json, pathlib, sys
from ezdxf.addons import meshex
def parts(path):
    if path.suffix == ".obj":
        return meshex.obj_loads(path.read_text())
    data = path.read_bytes()
    return [meshex.stl_loads(data.decode()) if data.startswith(b"solid") else meshex.stl_loadb(data)]
print(json.dumps([sum(len(m.faces) for m in parts(pathlib.Path(p))) for p in sys.argv[1:]]))
"""


def told(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0 or "ERROR" in done.stderr:
        raise AssertionError(f"{command}: {done.stderr}")
    return done.stdout


class Outputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """The scenes of tools/demo, with one block of houses and few points."""
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name)
        cls.clouds = [cls.folder / "vehicle.laz", cls.folder / "air.laz"]
        for scene, points, cloud in zip(("street", "street-air"), (150000, 40000), cls.clouds):
            must("scan", scene, "-o", cloud, "--points", points, "--set", "scene.blocks=1", "-q")
        cls.out, cls.made = cls.folder / "out", cls.folder / "made"
        must("run", *cls.clouds, "-o", cls.out, "--products", "planes,roofs,facades,streets", "-q", "--set", "roofs.dtm=true", codes=(0, 3))
        must("export", cls.out, "--to", "glb,stl,ply,citygml,ifc,3dtiles", "-o", cls.made)
        must("convert", cls.out / "points" / "vehicle.laz", cls.made / "vehicle.copc.laz", "-q")
        cls.counts = json.loads((cls.out / "run.json").read_text())["counts"]
        cls.facades = {p.stem: json.loads(p.read_text()) for p in sorted((cls.out / "facades").glob("*.json"))}
        assert cls.counts["planes"] and cls.counts["roofs"]["buildings"] and cls.facades and cls.counts["streets"]["objects"]

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def files(self, *kinds):
        found = [p for folder in (self.out, self.made) for p in sorted(folder.rglob("*")) if p.suffix in kinds]
        self.assertTrue(found, f"the run made no {kinds}")
        return found

    def test_every_kind_is_read(self):
        kinds = {p.suffix for folder in (self.out, self.made) for p in folder.rglob("*") if p.is_file()}
        self.assertEqual(kinds - READ, set())

    def layers(self, path):
        """name -> (how many features, their geometry) as GDAL finds them; all are in the reference system of the run."""
        found = {}
        for name, kind in re.findall(r"^\d+: (\w+) \((.*)\)$", told("ogrinfo", "-ro", "-q", path), re.M):
            if kind == "None":  # a table of styles
                continue
            text = told("ogrinfo", "-ro", "-so", path, name)
            self.assertIn(f'ID["EPSG",{CRS[5:]}]', text)
            found[name] = int(text.split("Feature Count: ")[1].split()[0]), kind
        return found

    def test_geopackages(self):
        counts, streets = self.counts, self.counts["streets"]
        models = readers.city_models(self.out / "roofs" / "roofs.city.jsonl").values()
        faces = sum(levels["2.2"].kinds.count("RoofSurface") for _, levels in models if "2.2" in levels)
        expected = {"planes.gpkg": {"planes": (counts["planes"], "3D Multi Polygon")},
                    "roofs.gpkg": {"buildings": (counts["roofs"]["buildings"], "Multi Polygon"), "roof_faces": (faces, "3D Polygon")},
                    "blocks.gpkg": {"blocks": (streets["blocks"], "3D Line String"), "gaps": (streets["gaps"], "3D Line String")},
                    "objects.gpkg": {"objects": (streets["objects"], "3D Point"), "extents": (streets["objects"], "Polygon")},
                    "trees.gpkg": {"trees": (streets["trees"], "3D Point"), "crowns": (streets["trees"], "Polygon")},
                    "kerbs.gpkg": {"kerbs": (streets["kerbs"], "3D Line String"), "heights": (self.kerb_vertices(), "3D Point")},
                    "pavements.gpkg": {"pavements": (streets["pavements"], "3D Polygon"),
                                       "widths": (streets["pavement_widths"], "3D Line String"),
                                       "road_edges": (streets["kerbs"], "3D Line String"),
                                       "carriageways": (streets["carriageways"], "Polygon")}}
        self.assertEqual({p.name: self.layers(p) for p in self.files(".gpkg")}, expected)

    def kerb_vertices(self):
        """Places of measured heights: one at each vertex of a line that was seen."""
        drawn = json.loads(told("ogr2ogr", "-f", "GeoJSON", "/vsistdout/", self.out / "streets" / "kerbs.gpkg", "kerbs"))["features"]
        return sum(len(f["geometry"]["coordinates"]) for f in drawn if f["properties"]["seen"])

    def test_rasters(self):
        """GDAL reads every pixel (its checksum); pictures of facades lie where their .pgw says."""
        self.assertEqual({p.stem for p in self.files(".tif")}, {"range", "accumulation", "ground", "artefacts", "dtm", "dtm_points"})
        for path in self.files(".tif", ".png"):
            copy = self.folder / path.name  # GDAL writes a file beside it
            shutil.copy(path, copy)
            world = path.with_suffix(".pgw")
            if path.suffix == ".png":
                shutil.copy(world, self.folder)
            read = json.loads(told("gdalinfo", "-json", "-checksum", "-stats", copy))
            self.assertTrue(read["bands"])
            if path.suffix == ".tif":
                self.assertIn(f'ID["EPSG",{CRS[5:]}]', read["coordinateSystem"]["wkt"])
                self.assertLess(read["bands"][0]["minimum"], read["bands"][0]["maximum"], path.name)
            else:
                step, _, _, down, x, y = map(float, world.read_text().split())
                for got, true in zip(read["geoTransform"], (x - step / 2, step, 0, y - down / 2, 0, down), strict=True):
                    self.assertAlmostEqual(got, true, places=6)

    def test_citygml(self):
        copy = self.folder / "copy.gml"  # GDAL writes a file beside it
        shutil.copy(self.made / "roofs.gml", copy)
        self.assertEqual(self.layers(copy)["Building"][0], self.counts["roofs"]["buildings"])

    def test_drawings(self):
        python = python_with_ezdxf()
        if not python:
            self.skipTest("no Python with ezdxf (apt install python3-ezdxf)")
        drawings = self.files(".dxf")
        self.assertEqual([p.stem for p in drawings], list(self.facades))
        for path, read in zip(drawings, json.loads(told(python, "-c", AUDIT, *drawings)), strict=True):
            self.assertEqual((read["errors"], read["fixes"], read["units"]), (0, 0, 6), path.name)
            known = {str(e["id"]) for e in self.facades[path.stem]["elements"]}
            self.assertLessEqual({row["ID"] for row in read["schedule"]}, known)
            self.assertEqual([name for name, _ in read["images"]], [path.stem + ".png"])
            self.assertGreater(int(told("ogrinfo", "-ro", "-so", path, "entities").split("Feature Count: ")[1].split()[0]), 0)

    def test_meshes(self):
        """ezdxf's readers of OBJ and STL find faces in each."""
        python = python_with_ezdxf()
        if not python:
            self.skipTest("no Python with ezdxf (apt install python3-ezdxf)")
        meshes = self.files(".obj", ".stl")
        for path, faces in zip(meshes, json.loads(told(python, "-c", MESHES, *meshes)), strict=True):
            data = path.read_bytes()
            if path.suffix == ".stl" and not data.startswith(b"solid"):
                true = (len(data) - 84) / 50
            else:
                true = sum(line.lstrip().startswith((b"f ", b"facet ")) for line in data.splitlines())
            self.assertGreater(true, 0, path.name)
            self.assertEqual(faces, true, path.name)
        for path in (p for p in meshes if p.suffix == ".obj"):
            used = {line.split()[1] for line in path.read_text().splitlines() if line.startswith("usemtl ")}
            library = path.with_suffix(".mtl")
            has = {line.split()[1] for line in library.read_text().splitlines() if line.startswith("newmtl ")} if library.exists() else set()
            self.assertLessEqual(used, has, path.name)

    def decoded(self, cloud):
        """The places of all points, as integers, by laz-perf; the header is read by its specification."""
        raw = self.folder / "raw"
        told("node", ROOT / "tests/oracles/lazperf_decode.mjs", cloud, raw)
        length, = struct.unpack_from("<H", cloud.read_bytes(), 105)
        records = raw.read_bytes()
        return sorted(records[i:i + 12] for i in range(0, len(records), length))

    @unittest.skipUnless(npm_has("laz-perf"), "no node, or no laz-perf below ILOT_NPM")
    def test_clouds(self):
        """laz-perf finds all points of the inputs in the labelled clouds, at the same places."""
        total = 0
        for cloud in self.clouds:
            before, after = self.decoded(cloud), self.decoded(self.out / "points" / cloud.name)
            self.assertTrue(before == after, cloud.name)
            total += len(after)
        self.assertEqual(total, self.counts["points"]["read"])

    @unittest.skipUnless(npm_has("copc"), "no node, or no copc below ILOT_NPM")
    def test_copc(self):
        """copc.js finds all points, each in the cube of its node."""
        read = told("node", ROOT / "tests/oracles/copc_nodes.mjs", self.made / "vehicle.copc.laz").split()
        nodes, points, outside, declared = map(int, read[:4])
        header = (self.out / "points" / "vehicle.laz").read_bytes()[:375]
        true, = struct.unpack_from("<Q", header, 247) if header[25] >= 4 else struct.unpack_from("<I", header, 107)
        self.assertGreater(nodes, 1)
        self.assertEqual((points, outside, declared, read[4]), (true, 0, true, "true"))

    @unittest.skipUnless(npm_has("web-ifc"), "no node, or no web-ifc below ILOT_NPM")
    def test_ifc(self):
        for path in self.files(".ifc"):
            read = seen_in_ifc(path)
            self.assertEqual((read["schema"], read["crs"]), ("IFC4X3_ADD2", CRS), path.name)
            kind = "IfcBuilding" if path.stem == "roofs" else "IfcWall"
            self.assertTrue([e for e in read["elements"] if e["type"] == kind], f"{path.name} has no {kind}")

    @unittest.skipUnless(npm_has("gltf-validator"), "no node, or no gltf-validator below ILOT_NPM")
    def test_glb(self):
        done = subprocess.run(["node", ROOT / "tests/oracles/gltf_faults.mjs", *self.files(".glb")], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)

    def test_subtrees(self):
        """Each file of subtrees and of models belongs to the tree of tiles, by a reader of the specification."""
        root, = [path for path in self.files(".json") if path.name == "tileset.json"]
        tileset = readers.read_tileset(root.parent)
        self.assertEqual(tileset["subtrees"], {f"{p.parent.name}/{p.name}" for p in self.files(".subtree")})
        tiles, models = [tileset["root"]], set()
        for tile in tiles:
            tiles += tile.get("children", [])
            models |= {tile["content"]["uri"]} if "content" in tile else set()
        self.assertEqual(models, {f"{p.parent.name}/{p.name}" for p in self.files(".glb") if root.parent in p.parents})

    @unittest.skipUnless(npm_has("3d-tiles-renderer"), "no node, or no 3d-tiles-renderer below ILOT_NPM")
    def test_subtrees_by_another_reader(self):
        """NASA's 3d-tiles-renderer finds each model in the files of subtrees."""
        root, = [path.parent for path in self.files(".json") if path.name == "tileset.json"]
        seen = json.loads(told("node", ROOT / "tests/oracles/subtrees_seen.mjs", root))
        self.assertEqual(sorted(tile["content"] for tile in seen if tile["content"]),
                         sorted(f"{p.parent.name}/{p.name}" for p in self.files(".glb") if root in p.parents))

    @unittest.skipUnless(npm_has("cityjson-threejs-loader"), "no node, or no cityjson-threejs-loader below ILOT_NPM")
    def test_cityjson(self):
        """TU Delft's loader finds each building in every level of detail, with as much wall, roof and ground as the sequence has."""
        seen = json.loads(told("node", ROOT / "tests/oracles/cityjson_seen.mjs", self.out / "roofs" / "roofs.city.json"))
        models = readers.city_models(self.out / "roofs" / "roofs.city.jsonl")
        self.assertEqual(set(seen), set(models))
        self.assertTrue(any("1.3" in levels for _, levels in models.values()))
        for name, (attributes, levels) in models.items():
            self.assertEqual(seen[name]["type"], "Building")
            self.assertEqual(set(seen[name]["levels"]), {"0", *levels})
            self.assertAlmostEqual(seen[name]["levels"]["0"]["GroundSurface"], attributes["area_m2"], delta=0.01 * attributes["area_m2"])
            for lod, solid in levels.items():
                areas = collections.Counter()
                for face, kind in zip(solid.faces, solid.kinds):
                    areas[kind] += readers.area(solid.vertices, face)
                self.assertEqual(set(seen[name]["levels"][lod]), set(areas))
                for kind, area in areas.items():
                    self.assertAlmostEqual(seen[name]["levels"][lod][kind], area, delta=1e-4 * area + 0.01)

    def test_texts(self):
        """JSON, CSV, SVG, HTML by Python's own readers; PDF by poppler; PLY and CityJSON by readers of their specifications."""
        for path in self.files(".json"):
            json.loads(path.read_text(encoding="utf-8"))
        for path in self.files(".csv"):
            with path.open(newline="", encoding="utf-8") as file:
                self.assertEqual(len({len(row) for row in csv.reader(file)}), 1, f"{path.name}: rows of different lengths")
        for path in self.files(".svg"):
            self.assertEqual(xml.etree.ElementTree.parse(path).getroot().tag, "{http://www.w3.org/2000/svg}svg")
        for path in self.files(".html"):
            tags = []
            reader = html.parser.HTMLParser()
            reader.handle_starttag = lambda tag, attributes: tags.append(tag)
            reader.feed(path.read_text(encoding="utf-8"))
            self.assertEqual((tags[0], tags.count("body")), ("html", 1))
        models = readers.city_models(self.out / "roofs" / "roofs.city.jsonl")
        self.assertEqual(len(models), self.counts["roofs"]["buildings"])
        self.assertEqual(set(models), {k for k, v in json.loads((self.out / "roofs" / "roofs.city.json").read_text())["CityObjects"].items()
                                       if v["type"] == "Building"})
        self.assertTrue(readers.read_ply(self.made / "roofs.ply")[2])

    def test_levels_of_roofs(self):
        """By JSON and our own arithmetic alone: levels of detail, volumes, walls and the heights of faces."""
        lines = (self.out / "roofs" / "roofs.city.jsonl").read_text().splitlines()
        head = json.loads(lines[0])
        self.assertEqual(head["metadata"]["sources"]["files"], "run.json")
        self.assertTrue((self.out / head["metadata"]["sources"]["files"]).exists())
        models = readers.city_models(self.out / "roofs" / "roofs.city.jsonl")
        steps = 0
        for line in lines[1:]:
            feature = json.loads(line)
            thing = feature["CityObjects"][feature["id"]]
            attributes, levels = models[feature["id"]]
            self.assertEqual([g["lod"] for g in thing["geometry"]][:1], ["0"])
            if attributes["status"] != "lod22":
                continue
            self.assertEqual([g["lod"] for g in thing["geometry"]], ["0", "1.2", "1.3", "2.2"])
            for lod, name in (("1.2", "volume_lod12_m3"), ("1.3", "volume_lod13_m3"), ("2.2", "volume_lod22_m3")):
                triangles = [t for face in levels[lod].faces for t in readers.fan(levels[lod].vertices, face)]
                self.assertAlmostEqual(readers.mesh_volume(triangles), attributes[name], delta=1e-3 * attributes[name] + 0.01)
            level = {round(levels["1.3"].vertices[face[0][0]][2], 4)
                     for face, kind in zip(levels["1.3"].faces, levels["1.3"].kinds) if kind == "RoofSurface"}
            steps += len(level) > 1
            walls = sum(readers.area(levels["2.2"].vertices, face)
                        for face, kind in zip(levels["2.2"].faces, levels["2.2"].kinds) if kind == "WallSurface")
            self.assertAlmostEqual(attributes["party_wall_m2"] + attributes["exterior_wall_m2"], walls, delta=0.01 + 1e-4 * walls)
            geometry = thing["geometry"][-1]
            for face, surface in zip(geometry["boundaries"][0], geometry["semantics"]["surfaces"]):
                if surface["type"] != "RoofSurface":
                    continue
                z = [levels["2.2"].vertices[v][2] for ring in face for v in ring]
                self.assertAlmostEqual(surface["h_roof_min"], min(z), 2)
                self.assertAlmostEqual(surface["h_roof_max"], max(z), 2)
                self.assertTrue(surface["h_roof_min"] <= surface["h_roof_50"] <= surface["h_roof_70"] <= surface["h_roof_max"])

    @unittest.skipUnless(shutil.which("pdftotext"), "no pdftotext (apt install poppler-utils)")
    def test_sheets(self):
        for path in self.files(".pdf"):
            self.assertTrue(told("pdftotext", path, "-").strip(), path.name)


if __name__ == "__main__":
    unittest.main()
