# SPDX-License-Identifier: Apache-2.0
"""One run and a plan over the same inputs, and what must be equal."""
import json
import random

from support import Las, RunTest, ilot


class PlanTest(RunTest):
    products = ""
    plans = 0

    def quarters(self, path):
        """Writes the cloud as four files whose borders are no borders of cells."""
        las = Las.read(path)
        rows = list(zip(las.records(), las.raw()))
        x, y = (sorted(p[axis] for p in las.raw())[las.count // 2] for axis in (0, 1))
        folder = self.folder / "tiles"
        folder.mkdir()
        for n in range(4):
            part = [r for r, p in rows if (p[0] < x) + 2 * (p[1] < y) == n]
            las.write(folder / f"{n}.las", part)
        return folder

    def one_run(self, inputs, *options, clouds=("--no-clouds",)):
        done = ilot("run", inputs, "-o", self.folder / "one", "--products", self.products, *clouds, *options, timeout=600)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return json.loads((self.folder / "one/run.json").read_text())

    def plan(self, inputs, *options):
        self.plans += 1
        plan = self.folder / f"plan-{self.plans}"
        done = ilot("plan", inputs, "-o", plan, "--products", self.products, *options, timeout=600)
        self.assertEqual(done.returncode, 0, done.stderr)
        return plan, json.loads((plan / "plan.json").read_text())

    def task(self, plan, number):
        return ilot("task", plan, number, "--threads", "1", "--memory", "96M", timeout=600)

    def merged(self, plan, *options, code=(0, 3)):
        out = self.folder / f"out-{plan.name}"
        done = ilot("merge", plan, "-o", out, "--no-report", *options, timeout=600)
        self.assertIn(done.returncode, code, done.stderr)
        self.assertFalse((out / ".store").exists())
        return json.loads((out / "run.json").read_text())

    def equal(self, one, inputs, size, *options, merge=(), clouds=False):
        """`clouds`: the one run wrote labelled clouds, and so does the plan. Returns the number of areas."""
        plan, what = self.plan(inputs, "--area-size", size, *options)
        numbers = [area["area"] for area in what["areas"]]
        random.Random(len(numbers)).shuffle(numbers)
        for number in numbers:
            done = self.task(plan, number)
            self.assertIn(done.returncode, (0, 3), done.stderr)
        merged = self.merged(plan, *merge, *(["--labels"] if clouds else []))
        if clouds:
            merged = self.all_clouds(plan, len(what["inputs"]))
            self.assertEqual(merged["inputs"], one["inputs"])
        self.assertEqual(merged["result_hash"], one["result_hash"], f"areas of {size} m")
        for key in ("results", "exit_code", "rejected", "parameters", "chosen", "counts", "cells", "warnings", "skipped"):
            self.assertEqual(merged.get(key), one.get(key), key)
        return len(numbers)

    def all_clouds(self, plan, inputs):
        out = self.folder / f"out-{plan.name}"
        for number in range(inputs, 0, -1):
            done = self.label(plan, number, out)
            self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((out / "run.json").read_text())

    def label(self, plan, number, out):
        return ilot("task", plan, "label", number, "-o", out, "--threads", "1", timeout=600)
