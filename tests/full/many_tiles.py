#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs with 3,000 tiles where 1,024 files may be open, which is also the hard limit, within --memory 96M."""
import unittest

from faults import Limits, limits


class ManyTiles(Limits):
    def test_three_thousand(self):
        tiles = self.tiles(3000)
        arguments = ["--set", "planes.min_points=20"]
        _, expected = self.work(tiles, *arguments, preexec_fn=limits(NOFILE=20000), timeout=3600)
        _, run_json = self.work(tiles, *arguments, "--memory", "96M", preexec_fn=limits(NOFILE=1024), timeout=3600)
        self.assertEqual(run_json["result_hash"], expected["result_hash"])
        self.assertLessEqual(run_json["peak_rss_bytes"], 96 << 20)


if __name__ == "__main__":
    suite = unittest.TestSuite([ManyTiles("test_three_thousand")])
    raise SystemExit(not unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful())
