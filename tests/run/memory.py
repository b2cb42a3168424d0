#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that the budget determines the peak and the input does not: three times the points need the same resident
memory. tests/full/memory_growth.py takes ten times the points."""
import pathlib
import random
import struct
import subprocess
import sys

from support import SANITIZED, SKIPPED, RunTest, ilot, main, small_las


class Memory(RunTest):
    def peak(self, points, *arguments):
        path = self.district(points)
        _, run_json = self.work(path, "--memory", "96M", "--threads", "2", *arguments, timeout=300)
        self.assertEqual(run_json["counts"]["points"]["read"], points)
        return run_json["peak_rss_bytes"]

    def check_growth(self, few, many):
        """From 400,000 points on all fixed buffers are full. The tasks that run at the same time change the peak by
        some MiB. Eight bytes for each further point are less than its coordinates alone need."""
        small, large = self.peak(few, "--block-points", "16384"), self.peak(many, "--block-points", "16384")
        self.assertLessEqual(large, small + 8 * (many - few), f"{small >> 20} MiB at {few} points, {large >> 20} MiB at {many}")
        self.assertLessEqual(large, 96 << 20)

    def test_three_times_the_points(self):
        self.check_growth(400000, 1200000)

    def test_rows_of_60000_bytes(self):
        """Buffers are bounded in bytes. Compression of such rows needs a model of each byte, and 96M is too little for
        that."""
        path = self.folder / "long.las"
        small_las(path, [(i % 8 * 1000, i // 8 * 1000, 0) for i in range(61)])
        data = bytearray(path.read_bytes())
        rows = [bytes(data[at:at + 20]).ljust(60000, b"\x07") for at in range(227, len(data), 20)]
        struct.pack_into("<H", data, 105, 60000)
        path.write_bytes(bytes(data[:227]) + b"".join(rows))
        for memory, *more in ((96, "--no-clouds"), (128,)):
            _, run_json = self.work(path, "--memory", f"{memory}M", "--threads", "2", *more)
            self.assertLessEqual(run_json["peak_rss_bytes"], memory << 20)
        refused = ilot("run", path, "-o", self.folder / "out96", "--memory", "96M")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("long.las: its rows of 60000 bytes take", refused.stderr)
        self.assertIn("--no-clouds", refused.stderr)

    def test_peak_stays_within_the_budget(self):
        self.assertLessEqual(self.peak(600000), 96 << 20)

    def test_a_peak_above_the_budget_is_said(self):
        """A plane that is dense in the middle and sparse around it is the known case (docs/limits.md)."""
        rng = random.Random(1)
        rows = [(rng.randrange(3000), rng.randrange(3000), rng.randrange(5)) for _ in range(800000)]
        rows += [(rng.randrange(-120000, 120000), rng.randrange(-120000, 120000), rng.randrange(20)) for _ in range(4000)]
        path = self.folder / "dense.las"
        small_las(path, rows)
        for memory in ("96M", "2G"):
            _, run_json = self.work(path, "--memory", memory, "--threads", "2", "--no-clouds", timeout=300)
            warned = [w for w in run_json["warnings"] if "the peak of memory was" in w]
            self.assertEqual(len(warned), 1 if run_json["peak_rss_bytes"] > run_json["memory_bytes"] else 0, run_json["warnings"])

    def test_threads_share_the_budget(self):
        """Sixteen threads and their memory pools need no more than one thread, and find the same."""
        path, hashes = self.district(400000), set()
        for memory, threads in (("96M", 16), ("96M", 1), ("2G", 2)):
            _, run_json = self.work(path, "--memory", memory, "--threads", threads, timeout=300)
            hashes.add(run_json["result_hash"])
            if memory == "96M":
                self.assertLessEqual(run_json["peak_rss_bytes"], 96 << 20, f"{threads} threads")
        self.assertEqual(len(hashes), 1)


class Matrix(RunTest):
    """Runs a sample of tests/full/memory_matrix.py."""

    def test_sites_far_apart_and_strays(self):
        script = pathlib.Path(__file__).resolve().parent.parent / "full" / "memory_matrix.py"
        done = subprocess.run([sys.executable, script, "--cases", "^(street_stray_200_km|two_streets_50_km_apart)$",
                               "--products", "streets", "--memory", "96M,1G", "--threads", "2", "--scale", "0.1",
                               "--folder", self.folder], capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("4 runs, 0 failures", done.stdout)


class Products(RunTest):
    """Data that do not fit are read in pieces and sorted on disk, and the result does not show it. With eight threads
    and 1G, each of these two clouds needs more than 140 MiB."""

    BUDGETS = ((96, 8), (1024, 3))  # MiB and threads

    def test_a_facade(self):
        cloud, asked = self.facade(1000000)
        run_json = self.within_budgets(self.BUDGETS, cloud, *asked, timeout=300)
        self.assertEqual(run_json[0]["counts"]["facades"]["facades"], 1)

    def test_a_street(self):
        cloud, asked = self.street(1000000)
        run_json = self.within_budgets(self.BUDGETS, cloud, *asked, timeout=300)
        self.assertGreater(run_json[0]["counts"]["streets"]["objects"], 20)


if __name__ == "__main__":
    if SANITIZED:
        print("SKIPPED: a sanitizer's own memory hides the engine's", file=sys.stderr)
        sys.exit(SKIPPED)
    main(synthetic=[Memory, Matrix, Products])
