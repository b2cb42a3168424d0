#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The budget sets the peak, the input does not: ten times the points, the same resident memory."""
import sys

from support import SANITIZED, SKIPPED, RunTest, main


class Memory(RunTest):
    def peak(self, points, *arguments):
        path = self.district(points)
        _, told = self.work(path, "--memory", "96M", "--threads", "2", *arguments, timeout=300)
        self.assertEqual(told["counts"]["points"]["read"], points)
        return told["peak_rss_bytes"]

    def test_ten_times_the_points(self):
        """From 400,000 points on all fixed buffers are full: two batches of four stretches are written."""
        small, large = self.peak(500000, "--block-points", "16384"), self.peak(5000000, "--block-points", "16384")
        self.assertLessEqual(large, 1.1 * small, f"{small >> 20} MiB at 500,000 points, {large >> 20} MiB at 5,000,000")
        self.assertLessEqual(large, 96 << 20)

    def test_peak_stays_within_the_budget(self):
        self.assertLessEqual(self.peak(1000000), 96 << 20)


if __name__ == "__main__":
    if SANITIZED:
        print("SKIPPED: a sanitizer's own memory hides the engine's", file=sys.stderr)
        sys.exit(SKIPPED)
    main(synthetic=[Memory])
