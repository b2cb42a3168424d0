#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""ilot replay from outside: what it finds of a unit is what the run wrote of it, and the run stays as it is."""
import hashlib
import json
import os
import pathlib
import sqlite3
import struct
import subprocess
import tempfile
import unittest

EXE = os.environ["ILOT_EXE"]


def ilot(*arguments):
    return subprocess.run([EXE, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def las_file(path, points):
    """LAS 1.2, point format 0, millimetres; points are (x, y, z, class)."""
    low = [min(p[i] for p in points) / 1000 for i in range(3)]
    high = [max(p[i] for p in points) / 1000 for i in range(3)]
    header = struct.pack("<4sHH16sBB32s32sHHHIIBHI5I", b"LASF", 0, 0, b"", 1, 2, b"test", b"test", 1, 2026, 227,
                         227, 0, 0, 20, len(points), len(points), 0, 0, 0, 0)
    header += struct.pack("<12d", 0.001, 0.001, 0.001, 0, 0, 0, high[0], low[0], high[1], low[1], high[2], low[2])
    path.write_bytes(header + b"".join(struct.pack("<iiiHBBbBH", x, y, z, 7, 9, c, 0, 0, 1) for x, y, z, c in points))
    return path


def houses(path):
    """Two gabled houses and a shed side by side on level ground, points every 30 cm."""
    points = []
    for i in range(120):
        for j in range(60):
            x, y = 300 * i + 7 * (j % 5), 300 * j + 5 * (i % 7)
            inside = 4000 <= y <= 14000 and (4000 <= x <= 12000 or 16000 <= x <= 24000 or 28000 <= x <= 32000)
            ridge = 8000 if x < 14000 else 20000
            roof = 3000 if x > 26000 else 6000 - abs(x - ridge) // 2
            points.append((x, y, roof if inside else 0, 6 if inside else 2))
    return las_file(path, points)


def sums(folder):
    return {path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(folder.rglob("*"))
            if path.is_file() and "replay" not in path.relative_to(folder).parts}


def building_in(path, name):
    """The feature without what depends on the buildings before it."""
    for line in path.read_text().splitlines():
        feature = json.loads(line)
        if feature.get("id") != name:
            continue
        thing = feature["CityObjects"][name]
        thing["attributes"].pop("unit_id", None)
        ids = [s["plane_id"] for g in thing["geometry"] for s in g["semantics"]["surfaces"] if "plane_id" in s]
        for geometry in thing["geometry"]:
            for surface in geometry["semantics"]["surfaces"]:
                if "plane_id" in surface:
                    surface["plane_id"] -= min(ids)
        return feature
    return None


class Replay(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)

    def tearDown(self):
        self.holder.cleanup()

    def run_of(self, cloud, name, *more):
        out = self.folder / name
        done = ilot("run", cloud, "-o", out, "-q", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out

    def units(self, out):
        listed = ilot("replay", out, "--list", "--all")
        self.assertEqual(listed.returncode, 0, listed.stderr)
        return [line.split()[0] for line in listed.stdout.splitlines()[:-1]]

    def refuse(self, arguments, *words):
        done = ilot("replay", *arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_buildings_are_those_of_the_run(self):
        cloud = houses(self.folder / "houses.las")
        out = self.run_of(cloud, "out", "--products", "roofs", "--keep-store")
        before = sums(out)
        units = self.units(out)
        self.assertEqual(len(units), 3)
        for unit in units:
            look = self.folder / unit.replace(":", "-")
            done = ilot("replay", out, unit, "-o", look, "-q")
            self.assertEqual(done.returncode, 0, done.stderr)
            name = unit.split(":", 1)[1]
            written = building_in(out / "roofs" / "roofs.city.jsonl", name)
            self.assertIsNotNone(written)
            self.assertEqual(building_in(look / "building.city.jsonl", name), written)
            self.assertTrue(json.loads((look / "replay.json").read_text())["same_as_run"])
            self.check_layers(look)
        self.assertEqual(sums(out), before)

    def check_layers(self, look):
        counted = json.loads((look / "replay.json").read_text())
        with sqlite3.connect(look / "steps.gpkg") as file:
            for layer, count in counted["layers"].items():
                self.assertEqual(file.execute(f"select count(*) from {layer}").fetchone()[0], count, layer)
            used, faces = file.execute("select sum(used), max(face) from points").fetchone()
            self.assertGreater(used, 100)
            self.assertEqual(faces, counted["layers"]["faces"])
        for picture in counted["pictures"]:
            self.assertEqual((look / picture).read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual([p for p in look.iterdir() if p.name.startswith(".")], [])

    def test_a_facade_is_that_of_the_run(self):
        cloud, stations = self.folder / "front.laz", self.folder / "front.stations.csv"
        scanned = ilot("scan", "facade-restoration", "-o", cloud, "--points", "60000", "-q")
        self.assertEqual(scanned.returncode, 0, scanned.stderr)
        out = self.run_of(cloud, "front", "--products", "facades", "--stations", stations, "--keep-store")
        before = sums(out)
        self.assertEqual(self.units(out)[0], "facade:1")
        look = self.folder / "look"
        done = ilot("replay", out, "facade:1", "--stations", stations, "-o", look, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((look / "facade.json").read_bytes(), (out / "facades" / "facade-001.json").read_bytes())
        counted = json.loads((look / "replay.json").read_text())
        self.assertTrue(counted["same_as_run"])
        drawn = json.loads((look / "facade.json").read_text())["elements"]
        self.assertEqual(counted["layers"]["elements"], len(drawn))
        with sqlite3.connect(look / "steps.gpkg") as file:
            openings = file.execute("select count(*) from searches where search = 'opening'").fetchone()[0]
            self.assertGreater(openings, 5)
            seen = {row[0] for row in file.execute("select distinct seen from cells")}
            self.assertLessEqual({"wall", "open", "unknown"}, seen)
            self.assertEqual(file.execute("select count(*) from elements").fetchone()[0], len(drawn))
        self.assertEqual(sums(out), before)
        self.refuse([out, "facade:99", "--stations", stations], "facade:1 to facade:")
        self.refuse([out, "facade:1"], "stations", "--stations")

    def test_a_tile_is_that_of_the_run(self):
        cloud = self.folder / "street.laz"
        scanned = ilot("scan", "street", "-o", cloud, "--points", "60000", "--set", "scene.blocks=1", "-q")
        self.assertEqual(scanned.returncode, 0, scanned.stderr)
        out = self.run_of(cloud, "street", "--products", "streets", "--keep-store")
        before = sums(out)
        listed = ilot("replay", out, "--list", "--all").stdout.splitlines()
        first = listed[0].split()
        look, same = self.folder / "look", self.folder / "same"
        done = ilot("replay", out, first[0], "-o", look, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = ilot("replay", out, f"tile:at:{first[2]},{first[3]}", "-o", same, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(json.loads((look / "replay.json").read_text())["same_as_run"])
        layers = sorted(path.name for path in (look / "layers").iterdir())
        self.assertLessEqual({"range.tif", "filled.tif", "zones.tif", "mask.tif", "height.tif", "candidates.tif"}, set(layers))
        for layer in layers:
            self.assertEqual((look / "layers" / layer).read_bytes(), (same / "layers" / layer).read_bytes())
        objects = 0
        for line in listed[:-1]:
            tile = self.folder / "tile"
            self.assertEqual(ilot("replay", out, line.split()[0], "-o", tile, "-q").returncode, 0)
            objects += json.loads((tile / "replay.json").read_text())["layers"]["objects"]
        with sqlite3.connect(out / "streets" / "objects.gpkg") as file:
            self.assertEqual(file.execute("select count(*) from objects").fetchone()[0], objects)
        self.assertEqual(sums(out), before)
        self.refuse([out, "tile:1,1"], "rows", "columns", "--list")

    def test_a_cell_is_that_of_the_run(self):
        out = self.run_of(houses(self.folder / "houses.las"), "planes", "--keep-store")
        before = sums(out)
        units = self.units(out)
        points = 0
        for unit in units:
            look = self.folder / "look"
            done = ilot("replay", out, unit, "-o", look, "-q")
            self.assertEqual(done.returncode, 0, done.stderr)
            counted = json.loads((look / "replay.json").read_text())
            self.assertTrue(counted["same_as_run"])
            points += counted["layers"]["points"]
        self.assertEqual(points, 7200)
        self.assertEqual(sums(out), before)
        self.refuse([out, "cell:1,2,3"], "the nearest is cell:")
        self.refuse([out, "cell:1,2"], "cell:at:E,N,H")
        column = next((out / ".store" / "blocks").glob("*.segment"))
        values = bytearray(column.read_bytes())
        values[16:20] = struct.pack("<I", 1 + struct.unpack("<I", values[16:20])[0])
        column.write_bytes(values)
        told = [ilot("replay", out, unit, "-q", "-o", self.folder / "changed") for unit in units]
        self.assertEqual(sorted(done.returncode for done in told)[-1], 3)
        self.assertIn("1 point has another segment", "".join(done.stderr for done in told))

    def test_a_changed_result_is_told(self):
        out = self.run_of(houses(self.folder / "houses.las"), "out", "--products", "roofs", "--keep-store")
        unit = self.units(out)[0]
        model = out / "roofs" / "roofs.city.jsonl"
        lines = model.read_text().splitlines()
        feature = json.loads(lines[1])
        for vertex in feature["vertices"]:
            vertex[2] += 10
        model.write_text("\n".join([lines[0], json.dumps(feature), *lines[2:]]) + "\n")
        done = ilot("replay", out, unit, "-q")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("roofs.city.jsonl", done.stderr)

    def test_faults(self):
        cloud = houses(self.folder / "houses.las")
        out = self.run_of(cloud, "out", "--products", "roofs", "--keep-store")
        self.refuse([], "OUT")
        self.refuse([out], "--list")
        self.refuse([out, "building:1", "--list"], "UNIT")
        self.refuse([out, "garden:1"], "building:ID")
        self.refuse([out, "building:none", "-q"], "no such building", self.units(out)[0].split("_")[0])
        self.assertFalse((out / "replay").exists())
        self.refuse([self.folder / "none", "building:1"], "no finished run")
        self.refuse([self.run_of(cloud, "bare", "--products", "roofs"), "building:1"], "--keep-store")
        self.refuse([self.run_of(cloud, "planes", "--keep-store"), "building:1"], "--products roofs")
        cloud.write_bytes(cloud.read_bytes()[:-1] + b"\x07")
        self.refuse([out, "building:1"], "houses.las changed")


if __name__ == "__main__":
    unittest.main()
