#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An input that changed: a plan with --update leaves only the areas around the change to do, and its merge has the bytes
of a run from scratch, of roofs with footprints and of planes. A plan with --statistics keeps the values of the other.
tests/full/plan_update.py has larger ones, also of roofs without footprints."""
import json

from support import Las, RunTest, ilot, main


class Update(RunTest):
    def tiles(self):
        """A district as sixteen files whose borders are no borders of areas."""
        las, folder = Las.read(self.cloud), self.folder / "tiles"
        folder.mkdir()
        rows = list(zip(las.records(), las.raw()))
        low, high = ([f(p[axis] for p in las.raw()) for axis in (0, 1)] for f in (min, max))
        for n in range(16):
            def inside(p, n=n):
                return all(min(3, 4 * (p[a] - low[a]) // (high[a] - low[a] + 1)) == (n % 4, n // 4)[a] for a in (0, 1))
            las.write(folder / f"{n:02}.las", [r for r, p in rows if inside(p)])
        return folder

    def footprints(self):
        points = Las.read(self.cloud).points()
        x0, y0 = min(p[0] for p in points), min(p[1] for p in points)
        features = []
        for n in range(200):
            x, y, side = x0 + n % 20 * 25, y0 + n // 20 * 25, 14
            ring = [[x, y], [x + side, y], [x + side, y + side], [x, y + side], [x, y]]
            features.append({"type": "Feature", "properties": {"id": n}, "geometry": {"type": "Polygon", "coordinates": [ring]}})
        path = self.folder / "footprints.geojson"
        path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
        return path

    def change(self, name):
        """Raises a part of the points of one file by 30 cm."""
        las = Las.read(self.inputs / name)
        rows = list(zip(las.records(), las.raw()))
        middle = sorted(p[0] for p in las.raw())[len(rows) // 2]
        raised = [r[:8] + (p[2] + round(0.3 / las.scale[2])).to_bytes(4, "little", signed=True) + r[12:] if p[0] > middle else r
                  for r, p in rows]
        las.write(self.inputs / name, raised)

    def make(self, points):
        self.cloud = self.district(points)
        self.inputs = self.tiles()

    def plan(self, name, *options):
        done = ilot("plan", "-o", self.folder / name, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / name / "plan.json").read_text()), done.stderr

    def work(self, name):
        """Runs the tasks whose parts are missing, and returns their number and the result of the merge."""
        plan, done = self.folder / name, 0
        for area in json.loads((plan / "plan.json").read_text())["areas"]:
            if not (plan / f"parts/{area['area']}").exists():
                self.assertIn(ilot("task", plan, area["area"], "--threads", "1").returncode, (0, 3))
                done += 1
        merged = ilot("merge", plan, "-o", self.folder / f"out-{name}", "--no-report")
        self.assertIn(merged.returncode, (0, 3), merged.stderr)
        return done, json.loads((self.folder / f"out-{name}/run.json").read_text())

    def one_run(self, *options):
        done = ilot("run", self.inputs, "-o", self.folder / "one", "--no-clouds", "--overwrite", *options)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return json.loads((self.folder / "one/run.json").read_text())

    def check(self, size, *options):
        first, _ = self.plan("first", self.inputs, "--area-size", size, *options)
        self.assertEqual(self.work("first")[0], len(first["areas"]))
        self.change("00.las")
        second, told = self.plan("second", self.inputs, "--update", self.folder / "first")
        left, merged = self.work("second")
        self.assertIn(f"{len(second['areas']) - left} of {len(second['areas'])} areas keep their part", told)
        self.assertGreater(left, 0)
        self.assertLess(left, len(second["areas"]))
        one = self.one_run(*options)
        self.assertEqual(merged["result_hash"], one["result_hash"])
        for key in ("results", "exit_code", "rejected", "parameters", "chosen"):
            self.assertEqual(merged[key], one[key], key)
        return left, len(second["areas"])

    def test_roofs_with_footprints(self):
        self.make(200_000)
        left, areas = self.check(40, "--products", "roofs", "--footprints", self.footprints())
        self.assertLess(left, areas / 2)

    def test_planes(self):
        self.make(60_000)
        left, areas = self.check(33, "--products", "planes")
        self.assertLess(left, areas / 2)

    def test_nothing_changed(self):
        self.make(60_000)
        options = ("--products", "roofs", "--footprints", self.footprints())
        self.plan("first", self.inputs, "--area-size", 60, *options)
        _, before = self.work("first")
        self.plan("again", "--update", self.folder / "first")
        left, after = self.work("again")
        self.assertEqual((left, after["result_hash"]), (0, before["result_hash"]))

    def test_statistics_are_kept(self):
        """Three of four points leave the cloud: its own distance of clusters would be another."""
        self.make(60_000)
        self.plan("first", self.inputs, "--area-size", 60, "--products", "roofs")
        self.work("first")
        for path in sorted(self.inputs.iterdir()):
            las = Las.read(path)
            las.write(path, las.records()[::4])
        updated, told = self.plan("second", self.inputs, "--update", self.folder / "first")
        self.assertIn("roofs.cluster_distance would be", told)
        scratch, _ = self.plan("scratch", self.inputs, "--area-size", 60, "--statistics", self.folder / "first")
        kept = [c for c in updated["notes"]["chosen"] if c["key"].startswith("roofs.cluster")]
        first = json.loads((self.folder / "first/plan.json").read_text())["notes"]["chosen"]
        self.assertEqual(kept, [c for c in first if c["key"].startswith("roofs.cluster")])
        self.assertEqual(self.work("second")[1]["result_hash"], self.work("scratch")[1]["result_hash"])

    def test_what_is_refused(self):
        self.make(60_000)
        self.plan("first", self.inputs, "--area-size", 60, "--products", "roofs")
        done = ilot("plan", self.inputs, "-o", self.folder / "second", "--update", self.folder / "first", "--products", "planes")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("--products", done.stderr)
        none = ilot("plan", self.inputs, "-o", self.folder / "second", "--update", self.folder / "none")
        self.assertEqual(none.returncode, 2, none.stderr)
        self.assertIn("there is no plan", none.stderr)
        self.assertFalse((self.folder / "second").exists())


if __name__ == "__main__":
    main(synthetic=[Update])
