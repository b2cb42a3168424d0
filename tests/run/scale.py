#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""One run and a plan with any number of areas give the same bytes: with outlines that are given and that are found, with
buildings that tasks skip, after tasks that ran twice, were damaged or belong to another plan. Also: what a plan refuses,
and the scripts that run it."""
import json
import shutil
import signal
import subprocess
import time

from support import EXE, Las, RunTest, ilot, kill_at_work, main


class Scale(RunTest):
    def setUp(self):
        super().setUp()
        self.cloud = self.district(200_000)
        self.inputs = self.halves(self.cloud)
        self.plans = 0

    def halves(self, path):
        """Writes the cloud as two files, west and east, in a folder."""
        las = Las.read(path)
        rows, middle = list(zip(las.records(), las.raw())), sorted(p[0] for p in las.raw())[las.count // 2]
        folder = self.folder / "tiles"
        folder.mkdir()
        las.write(folder / "west.las", [r for r, p in rows if p[0] < middle])
        las.write(folder / "east.las", [r for r, p in rows if p[0] >= middle])
        return folder

    def footprints(self):
        """Squares all over the district and beyond it; two overlap and one has no area."""
        points = Las.read(self.cloud).points()
        x0, y0 = min(p[0] for p in points), min(p[1] for p in points)
        x1, y1 = max(p[0] for p in points), max(p[1] for p in points)
        features, side, step = [], 14, 25
        for n in range(400):
            x, y = x0 - 30 + n % 20 * step, y0 - 30 + n // 20 * step
            if x > x1 + 30 or y > y1 + 30:
                continue
            w = 0 if n == 3 else side + step if n == 44 else side
            ring = [[x, y], [x + w, y], [x + w, y + side], [x, y + side], [x, y]]
            features.append({"type": "Feature", "properties": {"id": n, "name": f"n{n}", "share": n / 7},
                             "geometry": {"type": "Polygon", "coordinates": [ring]}})
        path = self.folder / "footprints.geojson"
        path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
        return path

    def one_run(self, *options):
        done = ilot("run", self.inputs, "-o", self.folder / "one", "--products", "roofs", "--no-clouds", *options)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return json.loads((self.folder / "one/run.json").read_text())

    def plan(self, *options):
        self.plans += 1
        plan = self.folder / f"plan-{self.plans}"
        done = ilot("plan", self.inputs, "-o", plan, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return plan, json.loads((plan / "plan.json").read_text())

    def task(self, plan, number, *options):
        return ilot("task", plan, number, "--threads", "1", *options)

    def merged(self, plan, *options, code=(0, 3)):
        out = self.folder / f"out-{plan.name}"
        done = ilot("merge", plan, "-o", out, "--no-report", *options)
        self.assertIn(done.returncode, code, done.stderr)
        return json.loads((out / "run.json").read_text())

    def equal_in_areas(self, one, sizes, *options):
        counts = []
        for size in sizes:
            plan, what = self.plan("--area-size", size, *options)
            counts.append(len(what["areas"]))
            for area in reversed(what["areas"]):
                self.assertIn(self.task(plan, area["area"], "--memory", "96M").returncode, (0, 3))
            merged = self.merged(plan)
            self.assertEqual(merged["result_hash"], one["result_hash"], f"areas of {size} m")
            for key in ("results", "exit_code", "rejected", "parameters"):
                self.assertEqual(merged[key], one[key], key)
            self.assertEqual(merged["counts"]["roofs"], one["counts"]["roofs"])
            if "footprints" in one:
                self.assertEqual(merged["footprints"], one["footprints"])
        return counts

    def test_outlines_that_are_given(self):
        options = ("--footprints", self.footprints())
        one = self.one_run(*options)
        self.assertGreater(one["counts"]["roofs"]["buildings"], 50)
        self.assertTrue(one["footprints"]["outside"])
        self.assertGreater(one["footprints"]["overlapping"], 0)
        self.assertEqual(one["exit_code"], 3, "a footprint without an area is skipped")
        one_area, few, many = self.equal_in_areas(one, (100_000, 100, 50), *options)
        self.assertEqual(one_area, 1)
        self.assertGreaterEqual(few, 4)
        self.assertGreaterEqual(many, 16)

    def test_found_by_shape(self):
        """The points lose their classes, so that ground and buildings are found: halos are wide."""
        options = ("--footprints", self.footprints(), "--set", "roofs.trust_classes=false")
        self.equal_in_areas(self.one_run(*options), (100,), *options)

    def test_outlines_that_are_found(self):
        one = self.one_run()
        self.assertGreater(one["counts"]["roofs"]["buildings"], 20)
        self.assertGreaterEqual(self.equal_in_areas(one, (100,))[0], 4)

    def test_tasks_again_and_beside_each_other(self):
        plan, what = self.plan("--area-size", 100, "--footprints", self.footprints())
        other, _ = self.plan("--area-size", 100, "--footprints", self.footprints(), "--set", "roofs.detail=0")
        numbers = [str(a["area"]) for a in what["areas"]]
        self.assertIn("areas have no part: 1, 2", ilot("merge", plan, "-o", self.folder / "out").stderr)
        twins = [subprocess.Popen([EXE, "task", plan, "1", "--threads", "1", "-q"], stderr=subprocess.DEVNULL) for _ in range(3)]
        self.assertTrue(all(twin.wait() in (0, 3) for twin in twins))
        part = plan / "parts/1"
        first = part.read_bytes()
        again = self.task(plan, 1)
        self.assertIn("is done, nothing is left to do", again.stderr)
        self.assertEqual(part.read_bytes(), first)
        kill_at_work(["task", plan, "2", "--threads", "1", "-q"], plan / "parts", ".2-")
        self.assertIn(self.task(plan, 2).returncode, (0, 3))
        (plan / "parts/3").write_bytes((plan / "parts/2").read_bytes()[:-9])  # of another area, and cut
        self.assertIn(self.task(other, 4).returncode, (0, 3))
        shutil.copy(other / "parts/4", plan / "parts/4")
        mixed = ilot("merge", plan, "-o", self.folder / "mixed")
        self.assertEqual(mixed.returncode, 2, mixed.stderr)
        self.assertIn("parts of another plan: 3, 4", mixed.stderr)
        self.assertFalse((self.folder / "mixed").exists())
        for number in numbers[2:]:
            done = self.task(plan, number)
            self.assertIn(done.returncode, (0, 3), done.stderr)
        self.assertEqual(self.merged(plan)["result_hash"], self.one_run("--footprints", self.footprints())["result_hash"])
        self.assertEqual([p.name for p in (plan / "parts").iterdir() if p.name.startswith(".")], [])
        part.write_bytes(first[:-1])
        self.assertIn("is damaged", self.task(plan, 1).stderr)
        self.assertEqual(part.read_bytes(), first)

    def test_missing_areas(self):
        plan, _ = self.plan("--area-size", 100, "--footprints", self.footprints())
        self.assertIn(self.task(plan, 2).returncode, (0, 3))
        record = self.merged(plan, "--allow-missing", code=(3,))
        self.assertIn("1", [s["where"] for s in record["skipped"] if s["what"] == "area"])

    def test_exit_codes(self):
        plan, _ = self.plan("--area-size", 100_000, "--footprints", self.footprints())
        self.assertEqual(self.task(plan, 2).returncode, 2)
        self.assertEqual(self.task(self.folder, 1).returncode, 2)
        broken = self.task(plan, 1, "--work", "/dev/null/none")
        self.assertEqual(broken.returncode, 75, broken.stderr)
        stopped = subprocess.Popen([EXE, "task", plan, "1", "--threads", "1", "-q"], stderr=subprocess.DEVNULL)
        while stopped.poll() is None and not any(p.name.startswith(".") for p in (plan / "parts").iterdir()):
            time.sleep(0.001)  # its folder is there once it hears signals
        stopped.send_signal(signal.SIGTERM)
        self.assertIn(stopped.wait(), (75, 0, 3))
        (plan / "parts/1").unlink(missing_ok=True)
        west = self.inputs / "west.las"
        data = west.read_bytes()
        west.write_bytes(data[:-40] + bytes(40))
        changed = self.task(plan, 1)
        self.assertEqual(changed.returncode, 1)
        self.assertIn("was changed after the plan was made", changed.stderr)
        west.unlink()
        self.assertEqual(self.task(plan, 1).returncode, 1)

    def test_what_is_refused(self):
        for options, why in ((("--products", "bogus"), "bogus: there is no such product"),
                             (("--products", "roof"), "did you mean 'roofs'"),
                             (("--products", "planes,bogus"), "bogus: there is no such product"),
                             (("--products", ""), "there are: planes"),
                             (("--stations", self.cloud), "only planes and facades read it"),
                             (("--products", "streets", "--stations", self.cloud), "only planes and facades read it"),
                             (("--set", "roofs.dtm=true"), "makes no terrain model"),
                             (("--set", "classes.write=true"), "writes no clouds")):
            done = ilot("plan", self.inputs, "-o", self.folder / "p", *options)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(why, done.stderr)
            self.assertFalse((self.folder / "p").exists())

    def test_products_in_one_order(self):
        for given, kept in (("roofs,roofs", ["roofs"]), ("streets,facades", ["facades", "streets"])):
            self.assertEqual(self.plan("--products", given)[1]["products"], kept)

    def test_a_damaged_plan(self):
        """Numbers that are places in lists."""
        plan, what = self.plan("--area-size", 100_000, "--footprints", self.footprints())

        def areas_with(inputs):
            return {"areas": [{**what["areas"][0], "inputs": inputs}]}

        def inputs_with(stations):
            return {"inputs": [{**what["inputs"][0], "stations": stations}, *what["inputs"][1:]]}

        for other in (areas_with([0, 2]), areas_with([1, 0]), areas_with([0, 1 + 2**32]), areas_with([-1, 0]),
                      inputs_with({"all": 1, "of_source": []}), inputs_with({"all": 2**16, "of_source": []}),
                      inputs_with({"all": 0, "of_source": [[1, 1]]}), inputs_with({"all": 0, "of_source": [[2**16, 0]]})):
            (plan / "plan.json").write_text(json.dumps({**what, **other}))
            done = self.task(plan, 1)
            self.assertEqual(done.returncode, 1, other)
            self.assertIn("is damaged; make the plan again", done.stderr)
        (plan / "plan.json").write_text(json.dumps(what))
        self.assertIn(self.task(plan, 1).returncode, (0, 3))

    def test_make_runs_the_plan(self):
        options = ("--footprints", self.footprints())
        plan, what = self.plan("--area-size", 100, *options)
        script = ilot("plan", plan, "--as", "make")
        self.assertEqual(script.returncode, 0, script.stderr)
        (self.folder / "Makefile").write_text(script.stdout)
        made = subprocess.run(["make", "-j3", "-s", "-f", self.folder / "Makefile", f"OUT={self.folder}/made", f"ILOT={EXE}"],
                              capture_output=True, text=True, timeout=600)
        self.assertEqual(made.returncode, 0, made.stdout + made.stderr)
        record = json.loads((self.folder / "made/run.json").read_text())
        self.assertEqual(record["result_hash"], self.one_run(*options)["result_hash"])
        told = ilot("plan", plan, "--estimate").stdout
        self.assertIn(f"{len(what['areas'])} areas of 100 m", told)
        for kind in ("slurm", "snakemake", "dask", "k8s"):
            self.assertIn(str(plan), ilot("plan", plan, "--as", kind).stdout)
        self.assertEqual(ilot("plan", plan, "--as", "cron").returncode, 2)


if __name__ == "__main__":
    main(synthetic=[Scale])
