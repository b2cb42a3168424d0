#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs 200 races of two runs (one folder, one store, two that resume), and kills a run at every call of the swap."""
import os
import unittest

import folder

RACES = int(os.environ.get("ILOT_RACES", "200"))


class Races(folder.Locks):
    def test_races(self):
        self.races(RACES, points=3000)


class Swap(folder.Overwrite):
    def test_killed_in_the_swap(self):
        reached = self.kill_the_swap(range(1, 200))
        print(f"{reached} calls of the swap")
        self.assertGreater(reached, 15)


if __name__ == "__main__":
    suite = unittest.TestSuite([Races("test_races"), Swap("test_killed_in_the_swap")])
    raise SystemExit(not unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful())
