#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Ten times the points need the same resident memory."""
import unittest

from memory import Memory


class Growth(Memory):
    def test_ten_times_the_points(self):
        self.check_growth(500000, 5000000)


if __name__ == "__main__":
    suite = unittest.TestSuite([Growth("test_ten_times_the_points")])
    raise SystemExit(not unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful())
