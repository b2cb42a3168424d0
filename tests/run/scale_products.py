#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Facades and streets of one run and of a plan have the same bytes: with stations that rows tell, that files are called
after, and without; alone and together with planes, with labelled clouds; when an input changed."""
import json
import shutil

from plan_support import PlanTest
from support import Las, ilot, main


class FacadesTest(PlanTest):
    products = "facades"

    def row(self):
        """A row of houses that two stations saw, and what is known of these."""
        path = self.scan_of_seed("row-wild", 4249)
        return path, ("--stations", path.with_suffix(".stations.csv"))

    def scan_of_seed(self, scene, seed):
        path = self.folder / f"{scene}-{seed}.las"
        done = ilot("scan", scene, "-o", path, "--points", 60_000, "--seed", seed, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        return path


class PlanOfFacades(FacadesTest):
    def by_station(self, path):
        """Writes the cloud as a file for each station that is called as it, and the points of the last one as two more."""
        las, folder = Las.read(path), self.folder / "stations"
        folder.mkdir()
        of_station = {}
        for record in las.records():
            of_station.setdefault(int.from_bytes(record[20:22], "little"), []).append(record)
        self.assertGreater(len(of_station), 1)
        last = of_station.pop(max(of_station))
        las.write(folder / "further-1.las", last[::2])
        las.write(folder / "further-2.las", last[1::2])
        for station, records in of_station.items():
            las.write(folder / f"{station}.las", records)
        return folder

    def test_stations_that_rows_tell(self):
        path, options = self.row()
        inputs = self.quarters(path)
        one = self.one_run(inputs, *options)
        self.assertGreater(one["counts"]["facades"]["facades"], 3)
        self.assertEqual(self.equal(one, inputs, 100_000, *options), 1)
        self.assertGreaterEqual(self.equal(one, inputs, 33, *options, merge=("--memory", "96M", "--threads", "1")), 4)

    def test_stations_that_files_are_called_after(self):
        path, options = self.row()
        inputs = self.by_station(path)
        self.assertGreaterEqual(self.equal(self.one_run(inputs, *options), inputs, 60, *options), 2)

    def test_stations_give_the_steps_of_outlines(self):
        """Planes alone need of the stations only their places and angular steps."""
        self.products = "planes"
        path, stations = self.row()
        options = (*stations, "--set", "boundaries.step=stations")
        self.assertGreaterEqual(self.equal(self.one_run(path, *options), path, 60, *options), 2)

    def test_without_stations(self):
        path, _ = self.row()
        self.assertGreaterEqual(self.equal(self.one_run(path), path, 60), 2)

    def updated(self, plan, *options):
        """An update of the plan, and the areas that are left to do."""
        second = self.folder / f"{plan.name}-later"
        done = ilot("plan", "-o", second, "--update", plan, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        areas = [area["area"] for area in json.loads((second / "plan.json").read_text())["areas"]]
        return second, [n for n in areas if not (second / f"parts/{n}").exists()]

    def test_what_changed(self):
        """Other points in one of the inputs, then other places of the stations, which no task reads."""
        path, options = self.row()
        inputs = self.quarters(path)
        plan, what = self.plan(inputs, "--area-size", 33, *options)
        for area in what["areas"]:
            self.assertEqual(self.task(plan, area["area"]).returncode, 0)
        las = Las.read(inputs / "0.las")
        las.write(inputs / "0.las", list(las.records())[::2])
        plan, left = self.updated(plan)
        self.assertIn(len(left), range(1, len(what["areas"])))
        for number in left:
            self.assertEqual(self.task(plan, number).returncode, 0)
        self.assertEqual(self.merged(plan)["result_hash"], self.one_run(inputs, *options)["result_hash"])
        moved = self.folder / "moved.csv"
        lines = [line.split(",") for line in options[1].read_text().split()]
        moved.write_text("\n".join(",".join([*line[:3], str(float(line[3]) + 0.3), *line[4:]] if line[0] != "name" else line)
                                   for line in lines))
        plan, left = self.updated(plan, "--stations", moved)
        self.assertEqual(left, [])
        shutil.rmtree(self.folder / "one")
        self.assertEqual(self.merged(plan)["result_hash"], self.one_run(inputs, "--stations", moved)["result_hash"])


class PlanOfStreets(PlanTest):
    products = "streets"

    def test_areas_of_a_street(self):
        inputs = self.quarters(self.scan("street", 100_000))
        one = self.one_run(inputs)
        self.assertGreater(one["counts"]["streets"]["objects"], 0)
        self.assertEqual(self.equal(one, inputs, 100_000), 1)
        self.assertGreaterEqual(self.equal(one, inputs, 1000, merge=("--memory", "96M", "--threads", "1")), 4)
        self.assertGreaterEqual(self.equal(one, inputs, 300), 8)

    def test_a_street_from_the_air(self):
        inputs = self.scan("street-air", 70_000)
        self.assertGreaterEqual(self.equal(self.one_run(inputs), inputs, 700), 3)


class PlanOfAll(FacadesTest):
    """All products that go on from one store, with their labelled clouds."""
    products = "planes,facades,streets"

    def test_labelled_clouds(self):
        path, options = self.row()
        inputs, options = self.quarters(path), (*options, "--set", "classes.write=true")
        one = self.one_run(inputs, *options, clouds=())
        plan, what = self.plan(inputs, "--area-size", 60, *options)
        for area in what["areas"]:
            self.assertEqual(self.task(plan, area["area"]).returncode, 0)
        self.merged(plan, "--labels")
        out = self.folder / f"out-{plan.name}"
        for number in (3, 1, 4, 2):
            self.assertEqual(self.label(plan, number, out).returncode, 0)
        record = json.loads((out / "run.json").read_text())
        for key in ("result_hash", "results", "inputs", "counts"):
            self.assertEqual(record[key], one[key], key)


if __name__ == "__main__":
    main(synthetic=[PlanOfFacades, PlanOfStreets, PlanOfAll])
