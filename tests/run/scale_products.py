#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Facades and streets of one run and of a plan have the same bytes: with stations that rows tell, that files are called
after, and without; alone and together with planes, with labelled clouds; when an input changed."""
import json
import shutil

from plan_support import PlanTest
from support import Las, ilot, main


class SeedTest(PlanTest):
    def scan_of_seed(self, scene, seed):
        path = self.folder / f"{scene}-{seed}.las"
        done = ilot("scan", scene, "-o", path, "--points", 60_000, "--seed", seed, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        return path


class FacadesTest(SeedTest):
    products = "facades"

    def row(self):
        """A row of houses that two stations saw, and what is known of these."""
        path = self.scan_of_seed("row-wild", 4249)
        return path, ("--stations", path.with_suffix(".stations.csv"))


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
        self.refused_without_stations(self.folder / "plan-1")
        self.assertGreaterEqual(self.equal(one, inputs, 33, *options, merge=("--memory", "96M", "--threads", "1")), 4)
        self.expected_sizes(self.folder / "plan-2")

    def refused_without_stations(self, plan):
        """A part with stations, and a plan.json that has lost them."""
        what = json.loads((plan / "plan.json").read_text())
        what["stations"]["list"] = []
        for given in what["inputs"]:
            given["stations"] = {"all": 0, "of_source": []}
        (plan / "plan.json").write_text(json.dumps(what))
        done = ilot("merge", plan, "-o", self.folder / "no")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("names a station that the plan does not have", done.stderr)

    def expected_sizes(self, plan):
        """The parts are about as large as the plan says."""
        expected = sum(area["part_bytes"] for area in json.loads((plan / "plan.json").read_text())["areas"])
        found = sum(path.stat().st_size for path in (plan / "parts").iterdir())
        self.assertLess(abs(found / expected - 1), 0.1, (found, expected))

    def test_stations_that_files_are_called_after(self):
        path, options = self.row()
        inputs = self.by_station(path)
        self.assertGreaterEqual(self.equal(self.one_run(inputs, *options), inputs, 60, *options), 2)

    def test_stations_give_the_steps_of_outlines(self):
        """Planes alone need of the stations only their places and angular steps."""
        self.products = "planes"
        path, stations = self.row()
        options = (*stations, "--set", "boundaries.step=stations", "--set", "planes.colour_classes=0")
        self.assertGreaterEqual(self.equal(self.one_run(path, *options), path, 60, *options), 2)
        self.expected_sizes(self.folder / "plan-1")  # without colours, which nothing reads then

    def test_without_stations(self):
        path, _ = self.row()
        self.assertGreaterEqual(self.equal(self.one_run(path), path, 60), 2)

    def test_colours_of_points_that_are_not_used(self):
        """Drawings are coloured where the format of an input has colours, though no point of this input is used."""
        las, folder = Las.read(self.row()[0]), self.folder / "formats"
        folder.mkdir()
        self.assertEqual(las.data[104], 7)
        records = list(las.records())
        withheld = [r[:15] + bytes([r[15] | 4]) + r[16:] for r in records[:100]]
        las.write(folder / "coloured.las", withheld)
        bare = bytearray(las.data[:las.start])
        bare[104], bare[105] = 6, las.length - 6
        Las(bytes(bare)).write(folder / "bare.las", [r[:30] + r[36:] for r in records])
        self.assertGreaterEqual(self.equal(self.one_run(folder), folder, 60), 2)

    def ptx(self, path, stations):
        """Writes the points of each station as a PTX file with its place, turned by nothing."""
        las, folder = Las.read(path), self.folder / "ptx"
        folder.mkdir()
        places = [line.split(",") for line in stations.read_text().split()]
        places = [dict(zip(places[0], row)) for row in places[1:]]
        of_station = {}
        for record, point in zip(las.records(), las.points()):
            of_station.setdefault(int.from_bytes(record[20:22], "little"), []).append((point, record[30:36:2]))
        for number, (name, points) in enumerate(sorted(of_station.items())):
            x, y, z = (float(places[number][axis]) for axis in "xyz")
            axes = "1 0 0\n0 1 0\n0 0 1\n"
            matrix = axes.replace("\n", " 0\n") + f"{x} {y} {z} 1\n"
            rows = "".join(f"{p[0] - x:.4f} {p[1] - y:.4f} {p[2] - z:.4f} 0.5 {c[0]} {c[1]} {c[2]}\n" for p, c in points)
            (folder / f"{name}.ptx").write_text(f"{len(points)}\n1\n{x} {y} {z}\n{axes}{matrix}{rows}")
        return folder

    def test_stations_of_ptx(self):
        path, (_, stations) = self.row()
        inputs = self.ptx(path, stations)
        one = self.one_run(inputs)
        self.assertGreater(one["counts"]["facades"]["facades"], 3)
        self.assertGreaterEqual(self.equal(one, inputs, 60), 2)

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


class PlanOfStreets(SeedTest):
    products = "streets"

    def test_areas_of_a_street(self):
        inputs = self.quarters(self.scan("street", 100_000))
        one = self.one_run(inputs)
        self.assertGreater(one["counts"]["streets"]["objects"], 0)
        self.assertEqual(self.equal(one, inputs, 100_000), 1)
        self.assertGreaterEqual(self.equal(one, inputs, 1000, merge=("--memory", "96M", "--threads", "1")), 4)
        self.assertGreaterEqual(self.equal(one, inputs, 300), 8)

    def test_class_codes_of_vegetation(self):
        inputs = self.scan_of_seed("street-wild", 44)
        one = self.one_run(inputs)
        self.assertRegex(json.dumps(one["chosen"]), "[1-9][0-9]* objects with such codes became vegetation")
        self.assertGreaterEqual(self.equal(one, inputs, 60), 2)

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
        out = self.folder / f"out-{plan.name}"
        (out / ".store/blocks").mkdir(parents=True)  # of a merge without --labels that was killed
        self.merged(plan, "--labels")
        for number in (3, 1, 4, 2):
            self.assertEqual(self.label(plan, number, out).returncode, 0)
        record = json.loads((out / "run.json").read_text())
        for key in ("result_hash", "results", "inputs", "counts"):
            self.assertEqual(record[key], one[key], key)


if __name__ == "__main__":
    main(synthetic=[PlanOfFacades, PlanOfStreets, PlanOfAll])
