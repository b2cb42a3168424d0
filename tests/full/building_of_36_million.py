#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the test run/large_building.py with a building of 36 million points."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "run"))
import large_building
from support import main

large_building.POINTS = 36000000
large_building.BUDGETS = ((256, 2), (2048, 2))
large_building.SECONDS = 3600

if __name__ == "__main__":
    main(synthetic=[large_building.LargeBuilding])
