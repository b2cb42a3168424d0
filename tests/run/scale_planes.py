#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Planes of one run and of a plan have the same bytes, for any number of areas and inputs, in any order of the tasks, also
with colours and curved shapes, after a task that was killed and a part of another plan. Also: what is refused."""
import json
import math
import random
import shutil
import struct
import subprocess

from plan_support import PlanTest
from support import EXE, Las, ilot, kill_at_work, main, real, small_las


class PlanesTest(PlanTest):
    products = "planes"


class PlanOfPlanes(PlanesTest):
    def test_areas_of_a_district(self):
        inputs = self.quarters(self.district(200_000))
        one = self.one_run(inputs)
        self.assertGreater(one["counts"]["planes"], 100)
        self.assertEqual(self.equal(one, inputs, 100_000), 1)
        self.assertGreaterEqual(self.equal(one, inputs, 130, merge=("--memory", "96M", "--threads", "1")), 4)
        self.assertGreaterEqual(self.equal(one, inputs, 33), 16)

    def test_curved_shapes(self):
        """A pipe that lies over the borders of cells on level ground: its parts are joined as planes are. A point far away
        is left out, and both say so."""
        rng, rows = random.Random(7), [(90_000_000, 90_000_000, 0)]
        for _ in range(40_000):
            turn, out = rng.uniform(0, 2 * math.pi), rng.gauss(1200, 4)
            rows.append((rng.randrange(12_000, 54_000), round(16_000 + out * math.cos(turn)), round(5000 + out * math.sin(turn))))
            rows.append((rng.randrange(0, 66_000), rng.randrange(0, 32_000), round(rng.gauss(0, 4))))
        inputs, options = small_las(self.folder / "pipe.las", rows), ("--set", "planes.curved=true")
        one = self.one_run(inputs, *options)
        self.assertGreater(one["counts"]["shapes"], 0)
        self.assertIn("1 point stands alone", one["warnings"][0])
        self.assertGreater(self.equal(one, inputs, 33, *options), 1)

    def test_colours(self):
        """Classes of colours are those of all points, also where a part has inputs without colours."""
        las, folder = Las.read(self.district(60_000)), self.folder / "coloured"
        self.assertEqual((las.data[104], las.length), (6, 35))
        x = sorted(p[0] for p in las.raw())[las.count // 2]
        west, east = [], []
        for record, p in zip(las.records(), las.raw()):
            if p[0] >= x:
                east.append(record)
            else:
                rgb = struct.pack("<3H", 65000 if p[2] % 3 else 300, p[0] % 60000, p[1] % 50000)
                west.append(record[:30] + rgb + record[30:])
        folder.mkdir()
        las.write(folder / "east.las", east)
        head = bytearray(las.data)
        struct.pack_into("<BH", head, 104, 7, 41)
        Las(bytes(head)).write(folder / "west.las", west)
        one = self.one_run(folder)
        with open(self.folder / "one/planes.csv") as file:
            self.assertIn("colour", file.readline())
        self.assertIn("planes.colour_classes", [c["key"] for c in one["chosen"]])
        self.assertGreater(self.equal(one, folder, 60), 1)

    def test_labelled_clouds(self):
        """One task for each input, after the merge; the last one makes the result whole."""
        inputs, options = self.quarters(self.district(100_000)), ("--set", "normals.write=true")
        one = self.one_run(inputs, *options, clouds=())
        plan, what = self.plan(inputs, "--area-size", 100, *options)
        self.assertEqual(ilot("task", plan, "label", 1).returncode, 2, "no -o")
        for area in what["areas"]:
            self.assertEqual(self.task(plan, area["area"]).returncode, 0)
        early = self.merged(plan)
        out = self.folder / f"out-{plan.name}"
        self.assertIn("run ilot merge with --labels first", self.label(plan, 1, out).stderr)
        shutil.rmtree(out)
        self.assertEqual(self.merged(plan, "--labels")["result_hash"], early["result_hash"])
        kill_at_work(["task", plan, "label", 2, "-o", out, "--threads", "1", "-q"], out, ".label-2-")
        self.assertEqual(self.label(plan, 5, out).returncode, 2)
        twins = [subprocess.Popen([EXE, "task", plan, "label", str(n), "-o", out, "--threads", "1", "-q"])
                 for n in (4, 2, 4, 1, 3, 2)]
        self.assertEqual([twin.wait() for twin in twins], [0] * 6)
        self.assertIn("is done, nothing is left to do", self.label(plan, 3, out).stderr)
        record = json.loads((out / "run.json").read_text())
        self.assertEqual([p.name for p in out.iterdir() if p.name.startswith(".")], [])
        for key in ("result_hash", "results", "inputs", "counts"):
            self.assertEqual(record[key], one[key], key)
        (plan / f"parts/{what['areas'][0]['area']}").unlink()
        holes = self.folder / "holes"  # a merge without labels: those that are there belong to the one before
        self.assertEqual(ilot("merge", plan, "-o", holes, "--allow-missing").returncode, 3)
        refused = self.label(plan, 1, holes)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("has not the result of the last merge", refused.stderr)
        self.assertFalse((holes / "points").exists())

    def test_tasks_that_fail(self):
        inputs = self.quarters(self.district(200_000))
        plan, what = self.plan(inputs, "--area-size", 130)
        other, _ = self.plan(inputs, "--area-size", 130, "--set", "planes.join_angle=7")
        last = what["areas"][-1]["area"]
        kill_at_work(["task", plan, 1, "--threads", "1", "-q"], plan / "parts", ".1-")
        twins = [subprocess.Popen([EXE, "task", plan, "1", "--threads", "1", "-q"]) for _ in range(2)]
        self.assertEqual([twin.wait() for twin in twins], [0, 0])
        first = (plan / "parts/1").read_bytes()
        self.assertIn("is done, nothing is left to do", self.task(plan, 1).stderr)
        self.assertEqual(self.task(other, 1).returncode, 0)
        shutil.copy(other / "parts/1", plan / "parts/1")
        for area in what["areas"][1:-1]:
            self.assertEqual(self.task(plan, area["area"]).returncode, 0)
        missing = ilot("merge", plan, "-o", self.folder / "out", "--allow-missing")
        self.assertEqual(missing.returncode, 2, missing.stderr)
        self.assertIn("parts of another plan: 1;", missing.stderr)
        self.assertIn("belongs to another plan", self.task(plan, 1).stderr)
        self.assertEqual((plan / "parts/1").read_bytes(), first)
        self.assertIn(f"has no part: {last};", ilot("merge", plan, "-o", self.folder / "out").stderr)
        record = self.merged(plan, "--allow-missing", code=(3,))
        self.assertIn(str(last), [s["where"] for s in record["skipped"] if s["what"] == "area"])
        self.assertGreater(record["counts"]["planes"], 10)
        (plan / "parts/1").write_bytes(first[:100_000] + b"x" + first[100_001:])
        damaged = ilot("merge", plan, "-o", self.folder / "damaged", "--allow-missing")
        self.assertEqual(damaged.returncode, 1, damaged.stderr)
        self.assertFalse((self.folder / "damaged/run.json").exists())

    def test_what_is_refused(self):
        inputs = self.district(20_000)
        for options, why in ((("--set", "planes.method=colour_ransac"), "colour_ransac"),
                             (("--set", "boundaries.step=stations"), "give --stations"),
                             (("--footprints", inputs), "only the product roofs reads it")):
            done = ilot("plan", inputs, "-o", self.folder / "p", "--products", "planes", *options)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(why, done.stderr)
            self.assertFalse((self.folder / "p").exists())


class RealPlanOfPlanes(PlanesTest):
    def test_delft_and_ign(self):
        for name, size in (("delft/ahn3_cropped_1.laz", 100), ("ign/870000_6618000.las", 70)):
            shutil.rmtree(self.folder / "one", ignore_errors=True)
            self.assertGreater(self.equal(self.one_run(real(name)), real(name), size), 3)


if __name__ == "__main__":
    main(synthetic=[PlanOfPlanes], real=[RealPlanOfPlanes])
