#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks how bench/wild sums up over seeds, and that it keeps what is finished and guards seeds for judging."""
import collections
import csv
import hashlib
import importlib.machinery
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import types
import unittest

WILD = pathlib.Path(__file__).resolve().parents[2] / "bench" / "wild"
sys.path.insert(0, str(WILD))
sys.dont_write_bytecode = True
import calibration  # noqa: E402
import figures  # noqa: E402
import losses  # noqa: E402

loader = importlib.machinery.SourceFileLoader("wild_run", str(WILD / "run"))
run = importlib.util.module_from_spec(importlib.util.spec_from_loader("wild_run", loader))
loader.exec_module(run)


def record(seed, value, **drawn):
    return {"scene": "facade-wild", "seed": seed, "figures": {"edges within 5 cm": value, "openings invented": 1 - value},
            "drawn": drawn, "commands": ""}


class Distributions(unittest.TestCase):
    def test_they_are_those_that_the_page_calls_frozen(self):
        digest = hashlib.sha256((WILD.parents[1] / "scan" / "wild" / "distributions.csv").read_bytes()).hexdigest()
        self.assertIn(digest, (WILD / "README.md").read_text(),
                      "distributions.csv changed: run the tables of bench/wild/README.md with both versions, then name the new hash")


class Losses(unittest.TestCase):
    def test_ranks_share_ties(self):
        self.assertEqual(losses.ranks([5, 1, 5, 0]), [2.5, 1, 2.5, 0])

    def test_rank_correlation_ignores_the_scale(self):
        self.assertAlmostEqual(losses.rank_correlation([1, 2, 3, 4], [1, 4, 9, 16]), 1)
        self.assertAlmostEqual(losses.rank_correlation([1, 2, 3, 4], [3, 2, 1, 0]), -1)
        self.assertEqual(losses.rank_correlation([1, 1, 1], [1, 2, 3]), 0)

    def test_the_worst_depends_on_what_is_better(self):
        rows = losses.figure_rows([record(i, i / 10) for i in range(11)])
        by_name = {row[0]: row for row in rows}
        self.assertEqual(by_name["edges within 5 cm"][1:5], ["11", "0.500", "0.100", "0.000"])
        self.assertEqual(by_name["openings invented"][1:5], ["11", "0.500", "0.900", "1.000"])
        self.assertEqual(by_name["openings invented"][5], "facade-wild 0")

    def test_the_parameter_with_the_greatest_difference_is_first(self):
        records = [record(i, 1 - i / 40, noise=i * 0.001, other=i % 2, side="left" if i < 20 else "right")
                   for i in range(40)]
        rows = losses.parameter_rows("facades", records)
        self.assertEqual([row[0] for row in rows[1:]], ["noise", "side", "other"])
        self.assertEqual(rows[1][5], "+1.00")
        self.assertEqual(rows[2][1:5], ["left", "0.237", "right", "0.738"])

    def test_a_failed_seed_has_lost_everything(self):
        failed = {"scene": "facade-wild", "seed": 3, "failed": "run: exit 1: no", "drawn": {}, "commands": "ilot scan"}
        self.assertEqual(losses.loss_of(failed, "facades"), 1)
        self.assertIn("failed: facade-wild 3: run: exit 1: no", losses.summary("facades", [failed, record(1, 1)]))


class Figures(unittest.TestCase):
    def test_every_figure_has_a_direction(self):
        stage = {"cpu_seconds": 2.0}
        record = {"inputs": [{"points": 500000}], "stages": [stage, stage], "peak_rss_bytes": 1 << 20}
        evaluation = {
            "edges": {"within": [{"limit_m": 0.01, "share": 0.5}, {"limit_m": 0.05, "share": 0.75}],
                      "stated": [{"status": "seen", "edges": 4, "within": 3, "median_stated_m": 0.02,
                                  "median_true_m": 0.01}]},
            "facades": {"judged": 4, "mirrored": 1}, "openings": {"true": 4, "found": 5, "matched": 3, "invented": 2}}
        found = figures.of("facades", evaluation, record)
        self.assertLessEqual(set(found), set(figures.DIRECTIONS))
        self.assertEqual(found["edges within 5 cm"], 0.75)
        self.assertEqual(found["mirrored"], 0.25)
        self.assertEqual(found["stated over true error"], 2)
        self.assertEqual(found["cpu s a million points"], 8)
        for product in figures.SCENES:
            self.assertIn(figures.MAIN[product], figures.DIRECTIONS)
            figures.of(product, {}, record)  # a truth that a product cannot be judged by is no fault


class Calibration(unittest.TestCase):
    def test_bins_of_scenes_are_added_before_they_are_judged(self):
        empty = {"count": 0, "mean_probability": None, "right": None}

        def scene(count, stated, right):
            return [empty] * 8 + [{"count": count, "mean_probability": stated, "right": right}, empty]

        pool = collections.defaultdict(lambda: [[0, 0.0, 0.0] for _ in range(calibration.BINS)])
        calibration.pooled(pool, "all", scene(10, 0.85, 1.0))
        self.assertAlmostEqual(calibration.error_of(pool["all"]), 0.15)
        calibration.pooled(pool, "all", scene(30, 0.85, 0.8))  # 34 of 40 are right: what is stated holds
        self.assertAlmostEqual(calibration.error_of(pool["all"]), 0)
        self.assertEqual(calibration.row_of("all", pool["all"]), "| all | 40 | 0.000 | 0.85 | 0.85 | 0.00 | - |")


class Guard(unittest.TestCase):
    def options(self, seeds, commit):
        return types.SimpleNamespace(product="facades", seeds=seeds, commit=commit, summary=False, note="a test")

    def test_seeds_for_judging_are_used_once(self):
        with tempfile.TemporaryDirectory() as folder:
            run.USED = pathlib.Path(folder) / "used.csv"
            run.check_and_note_use(self.options((0, 999), "a"), ["facade-wild"])
            self.assertFalse(run.USED.exists())
            run.check_and_note_use(self.options((1000, 1099), "a"), ["facade-wild"])
            run.check_and_note_use(self.options((1000, 1099), "a"), ["facade-wild"])  # goes on
            self.assertEqual(len(list(csv.DictReader(run.USED.read_text().splitlines()))), 1)
            with self.assertRaises(SystemExit):
                run.check_and_note_use(self.options((1050, 1200), "b"), ["facade-wild"])
            run.check_and_note_use(self.options((1100, 1200), "b"), ["facade-wild"])
            with self.assertRaises(SystemExit):
                run.check_and_note_use(self.options((900, 1000), "b"), ["facade-wild"])

    def test_a_program_that_fails_is_a_figure_and_is_not_run_again(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            program = folder / "ilot"
            program.write_text("#!/bin/sh\necho run >> " + str(folder / "calls") + "\necho no such scene >&2\nexit 2\n")
            program.chmod(0o755)
            command = [sys.executable, str(WILD / "run"), "facades", "--seeds", "0-1", "--exe", str(program), "--work",
                       str(folder / "work"), "--jobs", "1"]
            for _ in range(2):
                done = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("failed: facade-wild 0: scan: exit 2: no such scene", done.stdout)
            self.assertEqual((folder / "calls").read_text().count("run"), 2)


if __name__ == "__main__":
    unittest.main()
