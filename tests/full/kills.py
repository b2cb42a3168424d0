#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kills each product 100 times at random moments. Every second run is killed again while it resumes. The hash must be
the same."""
import os
import unittest

from resume import Resume

KILLS = int(os.environ.get("ILOT_KILLS", "100"))
SLOW = ["--threads", "1", "--block-points", "4096"]


class Kills(Resume):
    def check(self, product, points, scene="district"):
        path = self.folder / f"{scene}.las"
        self.scan(scene, points, path)
        self.check_kills(path, KILLS, 17, *SLOW, "--products", product)

    def test_planes(self):
        self.check("planes", 30000)

    def test_roofs(self):
        self.check("roofs", 30000)

    def test_streets(self):
        self.check("streets", 300000, "street")

    def test_facades(self):
        self.check("facades", 60000, "facade-restoration")


if __name__ == "__main__":
    unittest.main(verbosity=2)
