#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests bad input, bad requests and bad disks. Each must give one line with file, position and remedy, and nothing
half-written."""
import json
import math
import random
import resource
import struct
import subprocess

from support import EXE, RunTest, ilot, main, small_las

GRID = [(500 * i, 500 * j, 0) for i in range(40) for j in range(30)]


class BadInput(RunTest):
    def setUp(self):
        super().setUp()
        self.good = small_las(self.folder / "good.las", GRID)
        self.out = self.folder / "out"

    def tree(self):
        return {path: path.read_bytes() if path.is_file() else None for path in self.folder.rglob("*")}

    def refuse(self, inputs, *words, code=1, arguments=(), **options):
        """Expects one line on stderr with these words. The folder must not have changed."""
        before = self.tree()
        inputs = inputs if isinstance(inputs, list) else [inputs]
        done = ilot("run", *inputs, "-o", self.out, "-q", *arguments, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stdout, "")
        lines = [line for line in done.stderr.splitlines() if "no input says its unit" not in line]
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertTrue(lines[0].startswith("ilot: "), done.stderr)
        self.assertNotIn("internal error", done.stderr)
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(self.tree(), before, "nothing may be written")

    def bad_files(self):
        """Returns name and words of the message."""
        write = lambda name, data: (self.folder / name).write_bytes(data)
        good = self.good.read_bytes()
        write("empty.las", b"")
        write("text.las", b"this is not a point cloud at all\n" * 20)
        write("header.las", good[:100])
        zero = bytearray(good)
        struct.pack_into("<d", zero, 131, 0.0)
        write("zero.las", zero)
        endless = bytearray(good)
        struct.pack_into("<d", endless, 139, math.nan)
        write("nan-scale.las", endless)
        short = bytearray(good)
        struct.pack_into("<H", short, 105, 7)
        write("record.las", short)
        write("none.las", small_las(self.folder / "x.las", []).read_bytes())
        (self.folder / "x.las").unlink()
        return {"empty.las": ["empty"], "text.las": ["not a LAS"], "header.las": ["header"],
                "zero.las": ["scale of x", "131", "1e-12"], "nan-scale.las": ["scale of y"],
                "record.las": ["record length", "105"], "none.las": ["no points"]}

    def test_files_that_cannot_be_read(self):
        for name, words in self.bad_files().items():
            with self.subTest(name):
                self.refuse(self.folder / name, name, *words)

    def test_one_bad_among_good(self):
        for name in self.bad_files():
            with self.subTest(name):
                out, run_json = self.work([self.good, self.folder / name], code=3)
                self.assertEqual([s["where"] for s in run_json["skipped"]], [str(self.folder / name)])
                self.assertEqual(run_json["skipped"][0]["what"], "input")
                self.assertIn(name, run_json["skipped"][0]["reason"])
                self.assertEqual(run_json["exit_code"], 3)
                self.assertEqual(run_json["counts"]["points"]["read"], len(GRID))
                self.assertEqual([p.name for p in (out / "points").iterdir()], ["good.laz"])

    def test_strict(self):
        (self.folder / "empty.las").write_bytes(b"")
        self.refuse([self.good, self.folder / "empty.las"], "empty.las", arguments=["--strict"])

    def test_truncated_and_wrong_counts_are_repaired(self):
        data = self.good.read_bytes()
        cases = {"cut.las": (data[:227 + 20 * 900 + 7], 900)}
        lying = bytearray(data)
        struct.pack_into("<I", lying, 107, 4000000000)
        cases["lying.las"] = bytes(lying), len(GRID)
        for name, (content, points) in cases.items():
            with self.subTest(name):
                (self.folder / name).write_bytes(content)
                out, run_json = self.work(self.folder / name, code=3)
                self.assertEqual(run_json["counts"]["points"]["read"], points)
                self.assertIn(name, run_json["skipped"][0]["reason"])
                self.assertEqual(self.labelled(out, name[:-4]).count, points)

    def test_coordinates_that_are_no_numbers(self):
        rows = [f"{x / 1000} {y / 1000} {z / 1000}" for x, y, z in GRID]
        for place, word in ((5, "nan nan nan"), (77, "inf 0 0"), (200, "1 -inf 3")):
            rows[place] = word
        ply = self.folder / "holes.ply"
        ply.write_text("ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
                       "property double z\nend_header\n" % len(rows) + "\n".join(rows) + "\n")
        binary = self.folder / "binary.ply"
        values = b"".join(struct.pack("<3f", *map(float, row.split())) for row in rows)
        binary.write_bytes(b"ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\n"
                           b"property float y\nproperty float z\nend_header\n" % len(rows) + values)
        for path in (ply, binary):
            with self.subTest(path.name):
                out, run_json = self.work(path)
                self.assertEqual(run_json["counts"]["points"]["read"], len(rows))
                self.assertEqual(run_json["counts"]["points"]["rejected"], 3)
                self.assertEqual(run_json["counts"]["planes"], 1)
        ply.write_text("ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                       "property double z\nend_header\nnan 0 0\n0 0 inf\n")
        self.refuse(ply, "rejected")

    def test_degenerate_clouds(self):
        rng = random.Random(3)
        clouds = {"equal": [(1000, 2000, 3000)] * 5000, "line": [(7 * i, 14 * i, 21 * i) for i in range(5000)],
                  "one": [(1, 2, 3)], "two": [(1, 2, 3), (4, 5, 6)],
                  "far": [(-2**31, -2**31, -2**31), (2**31 - 1, 2**31 - 1, 2**31 - 1)] * 50,
                  "noise": [(rng.randrange(10**6), rng.randrange(10**6), rng.randrange(10**6)) for _ in range(3000)]}
        for name, points in clouds.items():
            with self.subTest(name):
                path = small_las(self.folder / f"{name}.las", points)
                hashes = set()
                for way in ([], ["--block-points", "256", "--threads", "3"]):
                    _, run_json = self.work(path, *way, code=3)
                    self.assertEqual(run_json["counts"]["points"]["read"], len(points))
                    self.assertEqual(run_json["counts"]["points"]["labelled"], 0)
                    self.assertEqual(run_json["skipped"][0]["what"], "product")
                    hashes.add(run_json["result_hash"])
                self.assertEqual(len(hashes), 1)

    def test_requests(self):
        self.refuse(self.folder / "none.las", "none.las: no such file", code=2)
        for arguments, words in ((["--set", "planes.epsilom=1"], ["planes.epsilom", "planes.epsilon"]),
                                 (["--set", "planes.epsilon=99"], ["planes.epsilon", "0.0001 to 10"]),
                                 (["--threads", "x"], ["--threads x: a number from"]), (["--memory", "1M"], ["memory"]),
                                 (["--bounds", "1,1,1,1"], ["bounds"])):
            self.refuse(self.good, *words, code=2, arguments=arguments)
        self.refuse(self.good, "rejected", arguments=["--bounds", "90000,90000,90001,90001"])

    def test_output_folders(self):
        self.out.mkdir()
        (self.out / "precious.txt").write_text("mine")
        self.refuse(self.good, "exists", code=2)
        for way in ("--overwrite", "--resume"):
            self.refuse(self.good, "something else", code=2, arguments=[way])
        (self.out / "precious.txt").unlink()
        self.out.rmdir()
        self.out.write_text("a file")
        for way in ([], ["--overwrite"], ["--resume"]):
            self.refuse(self.good, "out", code=2, arguments=way)
        self.out = self.out / "below" / "it"
        self.refuse(self.good, "cannot be created")
        self.refuse(self.good, "cannot be created", arguments=["--resume"])
        self.refuse(self.good, "cannot be created", arguments=["--store", self.folder / "store"])
        self.out = self.folder / "other"
        self.refuse(self.good, "/proc/ilot", "another place", arguments=["--store", "/proc/ilot"])

    def test_store_of_others_stays(self):
        store = self.folder / "store"
        (store / "blocks").mkdir(parents=True)
        (store / "blocks" / "thesis.txt").write_text("years of work")
        self.refuse(self.good, "something else", code=2, arguments=["--store", store])
        (store / "blocks" / "thesis.txt").unlink()
        (store / "blocks").rmdir()
        self.work(self.good, "--store", store)

    def test_input_in_the_output_stays(self):
        out, _ = self.work(self.good)
        inner = out / "points" / "good.laz"
        before = inner.read_bytes()
        for way in ("--overwrite", "--resume"):
            done = ilot("run", inner, "-o", out, way)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(inner.read_bytes(), before)

    def test_overwrite(self):
        """The output of the earlier run is replaced. A file that the user put beside it stays."""
        out, first = self.work(self.good)
        (out / "shapes.csv").write_text("somebody's own")
        others = ["density", "facades", "roofs", "streets"]
        for folder in ["points", *others]:
            (out / folder).mkdir(exist_ok=True)
            (out / folder / "stray").write_text("somebody's own")
        _, second = self.work(self.good, "--overwrite", out=out)
        self.assertEqual(first["result_hash"], second["result_hash"])
        ours = ["planes.csv", "planes.gpkg", "planes_neighbours.csv", "points", "run.json"]
        self.assertEqual(sorted(p.name for p in out.iterdir()), sorted(ours + others + ["shapes.csv"]))
        for folder in ["points", *others]:
            self.assertEqual((out / folder / "stray").read_text(), "somebody's own")

    def test_disk_full_at_any_size(self):
        """A limit on file sizes imitates a full disk. Every write may be the one that fails."""
        path = self.district(60000)
        _, whole = self.work(path)
        for limit in (0, 100, 5000, 50000, 300000, 500000):
            out = self.folder / f"full-{limit}"
            done = subprocess.run([EXE, "run", path, "-o", out, "-q", "--no-report"], capture_output=True, text=True, timeout=60,
                                  restore_signals=False,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
            with self.subTest(limit=limit, said=done.stderr):
                self.assertEqual(done.returncode, 1)
                lines = [line for line in done.stderr.splitlines() if line.startswith("ilot: ") and "unit" not in line]
                self.assertEqual(len(lines), 1)
                self.assertIn(str(out), lines[0])
                for name in ("run.json", "planes.csv", "points"):
                    self.assertFalse((out / name).exists(), name)
                _, run_json = self.work(path, "--resume", out=out)
                self.assertEqual(run_json["result_hash"], whole["result_hash"])


class BadBuildings(RunTest):
    """Tests invalid footprints and roofs. Every one must come back with a status and a reason, and every solid must be
    valid."""

    X, Y = 84000, 447000

    def setUp(self):
        super().setUp()
        self.rng = random.Random(8)
        self.points = []
        self.features = []

    def roof(self, x, y, width, depth, height, step=0.3, code=6):
        for i in range(int(width / step)):
            for j in range(int(depth / step)):
                px, py = x + (i + self.rng.random()) * step, y + (j + self.rng.random()) * step
                self.points.append((px, py, height(px, py) + self.rng.uniform(-0.03, 0.03), code))

    def footprint(self, name, *corners, shift=(0, 0)):
        ring = [[self.X + x - shift[0], self.Y + y - shift[1]] for x, y in (*corners, corners[0])]
        self.features.append({"type": "Feature", "properties": {"id": name},
                              "geometry": {"type": "Polygon", "coordinates": [ring]}})

    def box(self, name, x, y, width, depth, **way):
        self.footprint(name, (x, y), (x + width, y), (x + width, y + depth), (x, y + depth), **way)

    def model(self, *arguments, code=0, epsg=28992, cloud=None):
        """Returns the attributes by id."""
        if cloud is None:
            cloud = small_las(self.folder / "cloud.las", [(round(x * 1000), round(y * 1000), round(z * 1000), c)
                                                          for x, y, z, c in self.points], offset=(self.X, self.Y, 0))
        path = self.folder / "footprints.geojson"
        path.write_text(json.dumps({"type": "FeatureCollection", "features": self.features, "crs": {
            "type": "name", "properties": {"name": f"urn:ogc:def:crs:EPSG::{epsg}"}}}))
        out, run_json = self.work(cloud, "--products", "roofs", "--crs", "EPSG:28992", "--footprints", path, *arguments,
                              code=code)
        written = out / "roofs" / "roofs.city.jsonl"
        found = {}
        for line in written.read_text().splitlines()[1:]:
            feature = json.loads(line)
            found[feature["id"]] = feature["CityObjects"][feature["id"]]["attributes"]
        for name, attributes in found.items():
            self.assertIn(attributes["status"], ("lod22", "lod12", "footprint_only"), name)
            self.assertEqual(attributes["status"] == "lod22", not attributes.get("reason"), f"{name}: {attributes}")
        self.record = run_json
        self.assertEqual(run_json["counts"]["roofs"]["buildings"], len(found))
        self.assertEqual(run_json["counts"]["roofs"]["invalid"], 0)
        checked = ilot("validate", "-q", written)
        self.assertEqual(checked.returncode, 0, checked.stdout)
        return found

    def test_footprints(self):
        self.roof(0, 0, 60, 30, lambda x, y: 6 + min(y % 10, 10 - y % 10) / 2)
        self.box("house", 0, 0, 10, 10)
        self.footprint("bow-tie", (20, 0), (30, 10), (30, 0), (20, 10))
        self.footprint("flat", (12, 2), (12, 8), (12, 5))
        self.footprint("speck", (15, 5), (15.01, 5), (15.01, 5.01))
        self.box("empty", 500, 500, 10, 10)
        self.box("over", 40, 0, 10, 10)
        self.box("under", 45, 0, 10, 10)
        self.box("twin", 0, 0, 10, 10)
        found = self.model(code=3)
        self.assertEqual(set(found), {"house", "bow-tie", "bow-tie-2", "flat", "speck", "empty", "over", "under", "twin"})
        for name in ("house", "bow-tie", "bow-tie-2", "over", "under", "twin"):
            self.assertEqual(found[name]["status"], "lod22", found[name])
        for name in ("flat", "speck", "empty"):
            self.assertEqual(found[name]["status"], "footprint_only", found[name])
        self.assertNotIn("h_ground", found["empty"], "no point gives the height of its ground")
        self.assertNotIn("ground_source", found["empty"])
        self.assertIn("outline", found["bow-tie"])
        overlaps = {o["id"]: o["with"] for o in self.record["footprints"]["overlaps"]}
        self.assertEqual(overlaps, {"over": ["under"], "under": ["over"], "house": ["twin"], "twin": ["house"]})

    def test_points(self):
        self.roof(-5, -5, 110, 20, lambda x, y: 1, step=0.8, code=2)
        self.points += [(self.rng.uniform(0, 10), self.rng.uniform(0, 10), 6, 6) for _ in range(20)]
        self.box("few", 0, 0, 10, 10)
        self.points += [(20 + i * 0.05, 5, 6, 6) for i in range(200)]
        self.box("line", 20, 0, 10, 10)
        self.points += [(40 + self.rng.uniform(0, 10), self.rng.uniform(0, 10), 1.05 if i % 4 else 6, 6)
                        for i in range(1000)]
        self.box("glass", 40, 0, 10, 10)
        self.points += [(65, 5, 6, 6)] * 300
        self.box("stack", 60, 0, 10, 10)
        self.points += [(80 + self.rng.uniform(0, 10), self.rng.uniform(0, 10), self.rng.uniform(1, 9), 6)
                        for i in range(1000)]
        self.box("cloud", 80, 0, 10, 10)
        found = self.model(code=3)
        self.assertEqual(set(found), {"few", "line", "glass", "stack", "cloud"})
        for name, attributes in found.items():
            self.assertEqual(attributes["status"] == "footprint_only", name == "stack", name)
        self.assertEqual(found["line"]["status"], "lod12")

    def test_heights_that_are_no_numbers_and_no_classes(self):
        self.roof(-10, -10, 40, 40, lambda x, y: 7 if 0 <= x < 10 and 0 <= y < 10 else 1)
        self.box("house", 0, 0, 10, 10)
        rows = [f"{self.X + x} {self.Y + y} {'nan' if i % 50 == 0 else z}"
                for i, (x, y, z, _) in enumerate(self.points)]
        ply = self.folder / "cloud.ply"
        ply.write_text("ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
                       "property double z\nend_header\n" % len(rows) + "\n".join(rows) + "\n")
        found = self.model(cloud=ply)
        self.assertEqual(found["house"]["status"], "lod22", found)
        self.assertAlmostEqual(found["house"]["h_roof_50"], 7, delta=0.1)

    def test_footprints_in_another_crs(self):
        self.roof(0, 0, 10, 10, lambda x, y: 6)
        self.box("house", 0, 0, 10, 10, shift=(155000, 463000))  # RD Old: it differs from RD New only in its origin
        self.assertEqual(self.model(epsg=28991)["house"]["status"], "lod22")


if __name__ == "__main__":
    main(synthetic=[BadInput, BadBuildings])
