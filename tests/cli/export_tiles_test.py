#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""3D Tiles of a town and a hamlet far from it: the buildings of a small street, copied until they fill tiles of several levels and more
than one subtree, and its objects. ILOT_EXE names the program."""
import json
import pathlib
import sqlite3
import subprocess
import tempfile
import unittest

import export_readers as readers
from export_support import ROOT, must, npm_has

COPIES, APART, HAMLET = 11, 120.0, 20000.0  # rows and columns of copies, metres; the last copy stands alone, far east
MOST_TRIANGLES = 20000  # of a tile, docs/exports.md


def copied_town(path):
    """Copies every building of a CityJSONSeq beside itself, under new ids."""
    head, *lines = path.read_text().splitlines()
    scale = json.loads(head)["transform"]["scale"]
    out = [head]
    for row in range(COPIES):
        for column in range(COPIES):
            alone = HAMLET if row == column == COPIES - 1 else 0
            dx, dy = round((column * APART + alone) / scale[0]), round(row * APART / scale[1])
            for line in lines:
                feature = json.loads(line)
                name = f"{feature['id']}_{row}_{column}"
                feature["CityObjects"] = {name: feature["CityObjects"][feature["id"]]}
                feature["id"] = name
                feature["vertices"] = [[x + dx, y + dy, z] for x, y, z in feature["vertices"]]
                out.append(json.dumps(feature, separators=(",", ":")))
    path.write_text("\n".join(out) + "\n")
    return len(lines) * COPIES * COPIES


class Quarter(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.holder.name)
        must("scan", "street", "-o", folder / "s.laz", "--points", 150000, "-q", "--set", "scene.blocks=2")
        cls.out = folder / "out"
        must("run", folder / "s.laz", "-o", cls.out, "--products", "roofs,streets", "--no-clouds", "--no-report", "-q", codes=(0, 3))
        cls.buildings = copied_town(cls.out / "roofs" / "roofs.city.jsonl")
        cls.made = folder / "made"
        must("export", cls.out, "--to", "3dtiles", "-o", cls.made)
        cls.tileset = readers.read_tileset(cls.made / "3dtiles")
        cls.glbs = {p.name: readers.Glb(p.read_bytes()) for p in (cls.made / "3dtiles" / "tiles").iterdir()}
        cls.meshes = {name: list(glb.meshes()) for name, glb in cls.glbs.items()}

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def name(self, tile):
        return pathlib.Path(tile["content"]["uri"]).name if "content" in tile else None

    def walk(self, tile, above=None):
        """(tile, its bounds); boxes are in those above, errors shrink."""
        box = tile["boundingVolume"]["box"]
        bounds = [(box[k] - box[3 + 4 * k], box[k] + box[3 + 4 * k]) for k in range(3)]
        if above:
            outer, error = above
            self.assertTrue(all(a - 0.02 <= b and c <= d + 0.02 for (b, c), (a, d) in zip(bounds, outer)))
            self.assertLessEqual(tile["geometricError"], error)
        yield tile, bounds
        for child in tile.get("children", []):
            yield from self.walk(child, (bounds, tile["geometricError"]))

    def test_many_tiles_show_everything_once(self):
        ids, tiles = [], 0
        for tile, bounds in self.walk(self.tileset["root"]):
            tiles += 1
            self.assertEqual(tile["geometricError"] == 0, "children" not in tile)
            triangles = 0
            for _, primitives in self.meshes.get(self.name(tile), []):
                for primitive in primitives:
                    triangles += len(primitive["triangles"])
                    for x, y, z in (p for t in primitive["triangles"] for p in t):
                        self.assertTrue(all(low <= c <= high for c, (low, high) in zip((x, -z, y), bounds)))
            self.assertLessEqual(triangles, MOST_TRIANGLES)
            if self.name(tile):
                ids += self.tables(self.glbs[self.name(tile)]).get("building", {"id": []})["id"]
        self.assertGreater(tiles, 5)
        self.assertEqual(len(ids), self.buildings)
        self.assertEqual(len(set(ids)), self.buildings)

    def test_squares_and_subtrees(self):
        """What follows from the root alone: models stand in the square of their tile by their middle, the halved error is no less than
        that of the metadata, and each file belongs to one tile. Quarters without a model are not there."""
        tiles = [tile for tile, _ in self.walk(self.tileset["root"])]
        self.assertGreater(max(t["level"] for t in tiles), 4)
        self.assertGreater(len({t["subtree"] for t in tiles}), 1)
        self.assertTrue(any(0 < len(t.get("children", [])) < 4 for t in tiles))
        top = self.made / "3dtiles"
        self.assertEqual(sorted(t["content"]["uri"] for t in tiles if "content" in t), sorted(f"tiles/{p.name}" for p in (top / "tiles").iterdir()))
        self.assertEqual(self.tileset["subtrees"], {f"subtrees/{p.name}" for p in (top / "subtrees").iterdir()})
        for tile in tiles:
            self.assertGreaterEqual(tile["implicitError"], tile["geometricError"])
            for _, primitives in self.meshes.get(self.name(tile), []):
                corners = {}
                for primitive in primitives:
                    table = primitive["extensions"]["EXT_mesh_features"]["featureIds"][0]["propertyTable"]
                    for t, numbers in zip(primitive["triangles"], primitive["corners"]):
                        corners.setdefault((table, primitive["attributes"]["_FEATURE_ID_0"][numbers[0]]), []).extend((x, -z) for x, _, z in t)
                for places in corners.values():
                    for axis, (low, high) in enumerate(tile["square"]):
                        middle = (min(p[axis] for p in places) + max(p[axis] for p in places)) / 2
                        self.assertTrue(low - 0.01 <= middle <= high + 0.01)

    @unittest.skipUnless(npm_has("3d-tiles-tools"), "no node, or no 3d-tiles-tools below ILOT_NPM")
    def test_another_reader(self):
        """Cesium's 3d-tiles-tools finds the same tiles with the same boxes, errors, contents and subtrees."""
        done = subprocess.run(["node", ROOT / "tests/oracles/tiles_seen.mjs", self.made / "3dtiles"], capture_output=True, text=True, check=True)
        key = lambda t: (t["error"], t["box"])
        read = sorted(json.loads(done.stdout), key=key)
        mine = sorted(({"box": t["boundingVolume"]["box"], "error": t["geometricError"], "contents": [t["content"]["uri"]] if "content" in t else [],
                        "subtree": t["subtree"] if t["level"] % self.tileset["root"]["implicitTiling"]["subtreeLevels"] == 0 else None}
                       for t, _ in self.walk(self.tileset["root"])), key=key)
        self.assertEqual([{k: t[k] for k in mine[0]} for t in read], mine)

    @unittest.skipUnless(npm_has("3d-tiles-renderer"), "no node, or no 3d-tiles-renderer below ILOT_NPM")
    def test_a_renderer(self):
        """NASA's 3d-tiles-renderer finds the same tiles in the files of subtrees, each with the square and the error that follow
        from the root, and with the same model."""
        done = subprocess.run(["node", ROOT / "tests/oracles/subtrees_seen.mjs", self.made / "3dtiles"], capture_output=True, text=True, check=True)
        key = lambda t: (t["level"], t["x"], t["y"])
        read = sorted(json.loads(done.stdout), key=key)
        box = self.tileset["root"]["boundingVolume"]["box"]
        mine = []
        for tile, _ in self.walk(self.tileset["root"]):
            share = 2 * box[3] / 2 ** tile["level"]
            x, y = (round((tile["square"][k][0] - box[k] + box[3 + 4 * k]) / share) for k in range(2))
            mine.append({"level": tile["level"], "x": x, "y": y, "error": tile["implicitError"], "square": tile["square"],
                         "content": tile["content"]["uri"] if "content" in tile else None})
        for one, other in zip(read, sorted(mine, key=key), strict=True):
            self.assertEqual([one[k] for k in ("level", "x", "y", "content")], [other[k] for k in ("level", "x", "y", "content")])
            self.assertAlmostEqual(one["error"], other["error"], 6)
            for k, (low, high) in enumerate(other["square"]):
                half = one["box"][3 + 4 * k]
                self.assertAlmostEqual(one["box"][k] - half, low, 6)
                self.assertAlmostEqual(one["box"][k] + half, high, 6)

    def tables(self, glb):
        metadata = glb.json.get("extensions", {}).get("EXT_structural_metadata", {})
        return {t["name"]: t for t in (readers.property_table(glb, t) for t in metadata.get("propertyTables", []))}

    def test_coarse_tiles_show_the_large_buildings(self):
        """What a tile leaves to its children is no larger than its geometric error."""
        def largest(tile):
            below = [largest(child) for child in tile.get("children", [])]
            for size in below:
                self.assertLessEqual(size, tile["geometricError"] + 0.01)
            here, corners = 0.0, {}
            for _, primitives in self.meshes.get(self.name(tile), []):
                for primitive in primitives:
                    features = primitive["attributes"]["_FEATURE_ID_0"]
                    table = primitive["extensions"]["EXT_mesh_features"]["featureIds"][0]["propertyTable"]
                    for t, numbers in zip(primitive["triangles"], primitive["corners"]):
                        corners.setdefault((table, features[numbers[0]]), []).extend(t)
            for places in corners.values():
                here = max(here, sum((max(p[k] for p in places) - min(p[k] for p in places)) ** 2 for k in range(3)) ** 0.5)
            return max([here, *below])
        self.assertGreater(largest(self.tileset["root"]), 5)

    def test_objects_of_the_street(self):
        """Each object is once in the tiles, with the values of objects.gpkg and as large as these say."""
        with sqlite3.connect(self.out / "streets" / "objects.gpkg") as table:
            true = {row[0]: row[1:] for row in table.execute(
                "select object_id, class, probability, height_m, length_m, width_m, points from objects")}
        self.assertGreater(len(true), 5)
        found = {}
        for name, glb in self.glbs.items():
            objects = self.tables(glb).get("object")
            if objects is None:
                continue
            names = [t["name"] for t in glb.json["extensions"]["EXT_structural_metadata"]["propertyTables"]]
            corners = {}
            for _, primitives in self.meshes[name]:
                for primitive in primitives:
                    ids = primitive["extensions"]["EXT_mesh_features"]["featureIds"]
                    if names[ids[0]["propertyTable"]] != "object":
                        continue
                    for t, numbers in zip(primitive["triangles"], primitive["corners"]):
                        corners.setdefault(int(primitive["attributes"]["_FEATURE_ID_0"][numbers[0]]), []).extend(t)
            for row, number in enumerate(objects["object_id"]):
                self.assertNotIn(number, found)
                values = tuple(objects[k][row] for k in ("class", "probability", "height_m", "length_m", "width_m", "points"))
                found[number] = values
                heights = [y for _, y, _ in corners[row]]
                self.assertAlmostEqual(max(heights) - min(heights), values[2], delta=0.01)
                diagonal = max(((a[0] - b[0]) ** 2 + (a[2] - b[2]) ** 2) ** 0.5 for a in corners[row] for b in corners[row])
                self.assertAlmostEqual(diagonal / (values[3] ** 2 + values[4] ** 2) ** 0.5, 1, delta=0.002)
        self.assertEqual(set(found), set(true))
        for number, values in found.items():
            self.assertEqual(values[0], true[number][0])
            for one, other in zip(values[1:], true[number][1:]):
                self.assertAlmostEqual(one, other, 6)

    @unittest.skipUnless(npm_has("gltf-validator"), "no node, or no gltf-validator below ILOT_NPM")
    def test_validator(self):
        done = subprocess.run(["node", ROOT / "tests/oracles/gltf_faults.mjs", *self.made.rglob("*.glb")], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)


if __name__ == "__main__":
    unittest.main()
