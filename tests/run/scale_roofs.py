#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Roofs beside other products in one plan, and labelled clouds of roofs, have the bytes of one run: with outlines that are
given and that are found, with classes and without, where points coincide. Also: a part that is missing, and what is refused.
tests/full/plan_of_products.py has more areas."""
import json
import shutil

from plan_support import PlanTest
from support import Las, ilot, main


class RoofsTest(PlanTest):
    def footprints(self, cloud):
        """Squares all over the cloud and beyond it, some of which overlap; one has no area."""
        points = Las.read(cloud).points()
        (x0, y0), (x1, y1) = ([f(p[axis] for p in points) for axis in (0, 1)] for f in (min, max))
        features, step = [], 17
        for n in range(900):
            x, y = x0 - 30 + n % 30 * step, y0 - 30 + n // 30 * step
            side = 0 if n == 3 else 20 if n % 7 == 0 else 14
            if x > x1 + 30 or y > y1 + 30:
                continue
            ring = [[x, y], [x + side, y], [x + side, y + side], [x, y + side], [x, y]]
            features.append({"type": "Feature", "properties": {"id": n},
                             "geometry": {"type": "Polygon", "coordinates": [ring]}})
        path = self.folder / "footprints.geojson"
        path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
        return path


class PlanOfRoofsAndOthers(RoofsTest):
    products = "facades,planes,roofs,streets"

    def test_outlines_that_are_given(self):
        cloud = self.district(60_000)
        inputs, options = self.quarters(cloud), ("--footprints", self.footprints(cloud))
        one = self.one_run(inputs, *options, clouds=())
        self.assertGreater(one["counts"]["roofs"]["lod22"], 5)
        self.assertGreater(one["footprints"]["overlapping"], 10)
        self.assertGreater(one["counts"]["planes"], 10)
        merge = ("--memory", "128M", "--threads", "1")
        self.assertGreaterEqual(self.equal(one, inputs, 66, *options, merge=merge, clouds=True), 4)

    def test_outlines_that_are_found_by_shape(self):
        """Halos are wide, because ground and buildings are found."""
        inputs = self.quarters(self.district(60_000))
        options = ("--set", "roofs.trust_classes=false")
        one = self.one_run(inputs, *options, clouds=())
        self.assertGreater(one["counts"]["roofs"]["buildings"], 3)
        self.assertGreaterEqual(self.equal(one, inputs, 66, *options, clouds=True), 4)

    def test_storeys(self):
        """Facades, which the merge finds, give storeys to buildings, which the tasks have made."""
        inputs = self.scan("building", 100_000, storeys=3)
        self.products = "facades,roofs"
        one = self.one_run(inputs)
        self.assertIn('"storeys"', (self.folder / "one/roofs/roofs.city.jsonl").read_text())
        self.assertGreaterEqual(self.equal(one, inputs, 33), 1)

    def test_no_building(self):
        """Footprints that lie elsewhere, and a street without any: what run.json says of it."""
        inputs = self.scan("street-air", 20_000)
        self.products = "roofs,streets"
        far = self.folder / "far.geojson"
        ring = [[1e6, 1e6], [1e6 + 9, 1e6], [1e6 + 9, 1e6 + 9], [1e6, 1e6]]
        far.write_text(json.dumps({"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"id": 1}, "geometry": {"type": "Polygon", "coordinates": [ring]}}]}))
        options = ("--footprints", far)
        self.assertGreaterEqual(self.equal(self.one_run(inputs, *options), inputs, 1000, *options), 2)


class CloudsOfRoofs(RoofsTest):
    products = "roofs"

    def test_labelled_clouds(self):
        cloud = self.district(60_000)
        inputs, options = self.quarters(cloud), ("--footprints", self.footprints(cloud), "--set", "classes.write=true")
        one = self.one_run(inputs, *options, clouds=())
        self.assertGreaterEqual(self.equal(one, inputs, 66, "--labels", *options, clouds=True), 4)
        plan = self.folder / f"plan-{self.plans}"
        (plan / "parts/2").unlink()
        shutil.rmtree(self.folder / f"out-{plan.name}")
        self.merged(plan, "--labels", "--allow-missing", code=(3,))
        second = self.folder / "second"
        self.assertEqual(ilot("plan", "-o", second, "--update", plan).returncode, 0)
        self.assertTrue(json.loads((second / "plan.json").read_text())["labels"])

    def test_coincident_points(self):
        """Each point stands at the places of others, of other classes and in other files."""
        las, folder = Las.read(self.district(20_000)), self.folder / "twice"
        folder.mkdir()
        records = las.records()
        las.write(folder / "b.las", records)
        las.write(folder / "a.las", [r[:16] + bytes([6 if n % 3 else 2]) + r[17:] for n, r in enumerate(records)])
        one = self.one_run(folder, clouds=())
        self.assertGreater(one["counts"]["roofs"]["lod22"], 0)
        self.assertGreaterEqual(self.equal(one, folder, 33, "--labels", clouds=True), 4)

    def test_what_is_refused(self):
        plan, _ = self.plan(self.district(20_000), "--area-size", 100_000)
        self.assertIn(self.task(plan, 1).returncode, (0, 3))
        refused = ilot("merge", plan, "-o", self.folder / "no", "--labels")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("make it with ilot plan --labels", refused.stderr)


if __name__ == "__main__":
    main(synthetic=[PlanOfRoofsAndOthers, CloudsOfRoofs])
