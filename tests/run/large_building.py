#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests a building of any number of points. The peak must stay within the budget, and every budget and thread count
must give the same result."""
import json
import subprocess
import sys

from support import EXE, SANITIZED, SKIPPED, RunTest, main

POINTS = 600000  # tests/full/building_of_36_million.py has the large one
BUDGETS = ((96, 1), (1024, 3))  # MiB and threads
SECONDS = 300


class LargeBuilding(RunTest):
    def scanned(self):
        cloud = self.folder / "building.laz"
        done = subprocess.run([EXE, "scan", "building", "-o", cloud, "--points", str(POINTS), "-q"])
        self.assertEqual(done.returncode, 0)
        return cloud

    def check(self, cloud, *arguments):
        run_json = self.within_budgets(BUDGETS, cloud, "--products", "roofs", *arguments, timeout=SECONDS)
        self.assertEqual(run_json[0]["counts"]["roofs"]["thinned"], 1)
        self.assertEqual(run_json[0]["counts"]["roofs"]["lod22"], 1)

    def test_outline_found_and_given(self):
        cloud = self.scanned()
        self.check(cloud)  # a post beside the building encloses no area: that outline is no fault
        ring = [[650984, 6860987], [651016, 6860987], [651016, 6861013], [650984, 6861013], [650984, 6860987]]
        footprints = self.folder / "footprints.geojson"
        footprints.write_text(json.dumps({
            "type": "FeatureCollection",
            "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2154"}},
            "features": [{"type": "Feature", "properties": {"id": "b"},
                          "geometry": {"type": "Polygon", "coordinates": [ring]}}]}))
        self.check(cloud, "--footprints", footprints)


if __name__ == "__main__":
    if SANITIZED:
        print("SKIPPED: a sanitizer's own memory hides the engine's", file=sys.stderr)
        sys.exit(SKIPPED)
    main(synthetic=[LargeBuilding])
