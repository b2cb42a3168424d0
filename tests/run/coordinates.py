#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests units, coordinate systems and areas: what a run accepts, reports and writes."""
import csv
import json
import pathlib
import sqlite3
import struct

from support import Las, RunTest, ilot, main, real, small_las


def with_keys(path, keys):
    """Adds a GeoTIFF key record to a LAS file without records."""
    data = bytearray(pathlib.Path(path).read_bytes())
    body = struct.pack("<4H", 1, 1, 0, len(keys)) + b"".join(struct.pack("<4H", k, 0, 1, v) for k, v in keys)
    record = struct.pack("<H16sHH32s", 0, b"LASF_Projection", 34735, len(body), b"") + body
    struct.pack_into("<I", data, 96, 227 + len(record))
    struct.pack_into("<I", data, 100, 1)
    pathlib.Path(path).write_bytes(bytes(data[:227]) + record + bytes(data[227:]))
    return path


def crs_records(path):
    """Returns version, the flag of WKT, and the number of every record of a CRS in a LAS or LAZ file with its bytes."""
    data = pathlib.Path(path).read_bytes()
    at, = struct.unpack_from("<H", data, 94)
    records = []
    for _ in range(struct.unpack_from("<I", data, 100)[0]):
        user, number, length = struct.unpack_from("<2x16sHH", data, at)
        if user.rstrip(b"\0") == b"LASF_Projection":
            records.append((number, data[at + 54:at + 54 + length]))
        at += 54 + length
    return data[25], bool(data[6] & 16), records


def slope(z_scale=1.0):
    """Returns a roof-like plane of 20 x 20 m in raw millimetres, with heights divided by z_scale."""
    return [(250 * i, 250 * j, round((5000 + 50 * i) / z_scale)) for i in range(80) for j in range(80)]


def planes(out):
    with open(out / "planes.csv", newline="") as file:
        return list(csv.DictReader(file))


class CoordinatesTest(RunTest):
    def test_heights_in_feet_over_metres(self):
        foot = 1200 / 3937
        metres = with_keys(small_las(self.folder / "m.las", slope(), offset=(651000, 6861000, 0)), [(1024, 1), (3072, 2154)])
        feet = with_keys(small_las(self.folder / "f.las", slope(foot), offset=(651000, 6861000, 0)),
                         [(1024, 1), (3072, 2154), (4099, 9003)])
        self.assertIn("0.3048", ilot("info", feet).stdout)
        a, _ = self.work(metres)
        b, run_json = self.work(feet)
        one, two = planes(a), planes(b)
        self.assertEqual((len(one), len(two)), (1, 1))
        for name in ("nx", "ny", "nz", "area_m2"):
            if name in one[0]:
                self.assertAlmostEqual(float(one[0][name]), float(two[0][name]), delta=0.01 * max(1, float(one[0][name])))
        self.assertTrue(any("heights are in units of" in w for w in run_json["warnings"]), run_json["warnings"])
        self.assertEqual(self.labelled(b, "f").raw(), Las.read(feet).raw(), "records stay as they are")
        self.assertAlmostEqual(self.labelled(b, "f").scale[2], 0.001)
        residuals = [abs(r) for plane, r, _ in self.labelled(b, "f").labels() if plane]
        self.assertLess(max(residuals), 0.01)

    def test_degrees(self):
        rows = "".join(f"{3 + 3e-6 * i:.9f},{48.85 + 2e-6 * j:.9f},{50 + 0.02 * i:.3f}\n"
                       for i in range(70) for j in range(70))
        path = self.folder / "d.csv"
        path.write_text("x,y,z\n" + rows)
        refused = ilot("run", path, "-o", self.folder / "no", "--crs", "EPSG:4326")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--to-crs utm", refused.stderr)
        self.assertIn("EPSG:32631", refused.stderr)
        self.assertNotIn("or give --crs", refused.stderr)
        for target in ("utm", "EPSG:32631", "EPSG:2154"):
            out, run_json = self.work(path, "--crs", "EPSG:4326", "--to-crs", target)
            self.assertEqual(run_json["counts"]["planes"], 1)
            chosen = [c for c in run_json["chosen"] if c["key"] == "crs"]
            self.assertEqual(chosen[0]["value"], "EPSG:2154" if target == "EPSG:2154" else "EPSG:32631")
            self.assertEqual(run_json["counts"]["points"]["labelled"], 4900)
        wrong = ilot("run", path, "-o", self.folder / "no", "--crs", "EPSG:4326", "--to-crs", "EPSG:4979")
        self.assertEqual(wrong.returncode, 2)
        unknown = ilot("run", path, "-o", self.folder / "no", "--to-crs", "utm")
        self.assertEqual(unknown.returncode, 2)
        self.assertIn("give it with --crs", unknown.stderr)

    def test_degrees_that_cannot_be_are_not_believed(self):
        path = with_keys(small_las(self.folder / "d.las", slope(), offset=(515393, 4918000, 0)), [(1024, 2), (2048, 4326)])
        out, run_json = self.work(path)
        self.assertEqual(run_json["counts"]["planes"], 1)
        self.assertTrue(any("cannot be" in w for w in run_json["warnings"]))
        shown = json.loads(ilot("info", "--json", path).stdout)[0]
        self.assertTrue(shown["suits"]["planes"]["yes"])
        self.assertTrue(any("cannot be" in w for w in shown["warnings"]))
        given = ilot("run", path, "-o", self.folder / "no", "--crs", "EPSG:4326")
        self.assertEqual(given.returncode, 2)
        self.assertIn("cannot be", given.stderr)
        # As far from the origin as the surface of the Earth is from its centre.
        lambert = small_las(self.folder / "l.las", slope(), offset=(770550, 6277550, 0))
        for code, kind in ((4326, "is in degrees"), (4978, "is geocentric")):
            given = ilot("run", lambert, "-o", self.folder / "no", "--crs", f"EPSG:{code}")
            self.assertEqual(given.returncode, 2)
            self.assertIn(f"--crs EPSG:{code} {kind}, which x = 770", given.stderr)
            self.assertNotIn("--to-crs", given.stderr)
        out, run_json = self.work(with_keys(lambert, [(1024, 2), (2048, 4326)]))
        self.assertTrue(any("the inputs say degrees (EPSG:4326), which x = 770" in w for w in run_json["warnings"]))

    def test_what_cannot_be_projected_to_utm(self):
        path = self.folder / "pole.csv"
        path.write_text("x,y,z\n" + "".join(f"{3 + 3e-6 * i:.9f},{85 + 2e-6 * i:.9f},50\n" for i in range(90)))
        for words in ([], ["--to-crs", "utm"]):
            done = ilot("run", path, "-o", self.folder / "no", "--crs", "EPSG:4326", *words)
            self.assertEqual(done.returncode, 2)
            self.assertEqual("where UTM ends" in done.stderr, bool(words), done.stderr)
        self.assertIn("--to-crs EPSG:n projects them",
                      ilot("run", path, "-o", self.folder / "no", "--crs", "EPSG:4326").stderr)

    def test_layers_without_a_crs_are_cartesian(self):
        out, _ = self.work(small_las(self.folder / "a.las", slope()))
        with sqlite3.connect(out / "planes.gpkg") as file:
            ids = {row[0] for row in file.execute("select srs_id from gpkg_geometry_columns")}
        self.assertEqual(ids, {-1})
        out, _ = self.work(small_las(self.folder / "b.las", slope()), "--crs", "EPSG:2154")
        with sqlite3.connect(out / "planes.gpkg") as file:
            self.assertEqual({row[0] for row in file.execute("select srs_id from gpkg_geometry_columns")}, {2154})

    def crs_of(self, out):
        """Returns what a program that reads the only labelled cloud is told of its CRS."""
        path, = (out / "points").iterdir()
        done = ilot("info", "--json", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        info, = json.loads(done.stdout)
        self.assertFalse([w for w in info["warnings"] if "CRS" in w or "WKT" in w], "the records are where they belong")
        return info["crs"]

    def test_labelled_clouds_say_the_crs_of_the_run(self):
        old = small_las(self.folder / "old.las", slope())
        for name in ("text.csv", "mesh.ply", "modern.copc.laz"):
            self.assertEqual(ilot("convert", old, self.folder / name, "-q").returncode, 0)
        for name, version, numbers in (("old.las", 2, [34735]), ("text.csv", 4, [2112]), ("mesh.ply", 4, [2112]),
                                       ("modern.copc.laz", 4, [2112])):
            with self.subTest(name):
                out, run_json = self.work(self.folder / name, "--crs", "EPSG:2994")
                crs = self.crs_of(out)
                self.assertEqual((crs["epsg"], crs["metres_per_unit"]), (2994, 0.3048))
                self.assertEqual(run_json["crs"], {"name": "EPSG:2994", "metres_per_unit": 0.3048})
                minor, wkt, records = crs_records(next((out / "points").iterdir()))
                self.assertEqual((minor, wkt, [n for n, _ in records]), (version, version == 4, numbers))
                again, next_json = self.work(next((out / "points").iterdir()))
                self.assertEqual(next_json["crs"], run_json["crs"], "the next step has the same units")
                self.assertEqual(next_json["counts"]["planes"], run_json["counts"]["planes"])
                none, _ = self.work(self.folder / name)
                self.assertEqual(crs_records(next((none / "points").iterdir()))[2], [], "none was given")

    def test_a_given_crs_takes_the_place_of_that_of_the_input(self):
        path = with_keys(small_las(self.folder / "a.las", slope(), offset=(651000, 6861000, 0)), [(1024, 1), (3072, 2154)])
        out, _ = self.work(path, "--crs", "EPSG:28992")
        self.assertEqual(self.crs_of(out)["epsg"], 28992)
        self.assertEqual([n for n, _ in crs_records(out / "points/a.laz")[2]], [34735], "the one before is gone")
        without, _ = self.work(path)
        same, _ = self.work(path, "--crs", "EPSG:2154")
        self.assertEqual((same / "points/a.laz").read_bytes(), (without / "points/a.laz").read_bytes())
        bare = small_las(self.folder / "b.las", slope(), offset=(651030, 6861000, 0))
        both, _ = self.work([path, bare])
        for name in ("a", "b"):
            info, = json.loads(ilot("info", "--json", both / f"points/{name}.laz").stdout)
            self.assertEqual(info["crs"]["epsg"], 2154, "an input without a CRS has that of the others")
        self.assertEqual((both / "points/a.laz").read_bytes()[:375], (without / "points/a.laz").read_bytes()[:375])

    def test_labelled_clouds_say_the_unit_of_their_heights(self):
        path = small_las(self.folder / "a.las", slope(0.3048), offset=(651000, 6861000, 0))
        out, run_json = self.work(path, "--crs", "EPSG:2154+8228")  # NAVD88 height (ft)
        crs = self.crs_of(out)
        self.assertEqual((crs["epsg"], crs["metres_per_unit"], crs["metres_per_unit_z"]), (2154, 1, 0.3048))
        self.assertEqual(crs_records(out / "points/a.laz")[0], 2)
        self.assertEqual(self.labelled(out, "a").raw(), Las.read(path).raw())

    def test_reprojected_heights_have_the_unit_of_the_target(self):
        path = small_las(self.folder / "a.las", [(820 * i, 820 * j, 16400 + 164 * i) for i in range(70) for j in range(70)],
                         offset=(640000, 860000, 0))
        out, run_json = self.work(path, "--crs", "EPSG:2994", "--to-crs", "utm")  # feet
        self.assertEqual([w for w in run_json["warnings"] if "heights" in w], [])
        again, _ = self.work(out / "points/a.laz")
        for first, then in zip(planes(out), planes(again), strict=True):
            self.assertAlmostEqual(float(first["nz"]), 1 / 1.04 ** 0.5, delta=1e-3)
            self.assertAlmostEqual(float(first["centroid_z"]), (16.4 + 0.164 * 34.5) * 0.3048, delta=0.01)
            for key in ("nz", "centroid_z"):
                self.assertAlmostEqual(float(first[key]), float(then[key]), delta=1e-3)

    def test_labels_of_a_plan_say_its_crs(self):
        path = small_las(self.folder / "a.las", slope())
        one, run_json = self.work(path, "--crs", "EPSG:2994")
        plan, out = self.folder / "plan", self.folder / "merged"
        for words in (["plan", path, "-o", plan, "--products", "planes", "--crs", "EPSG:2994"], ["task", plan, 1],
                      ["merge", plan, "-o", out, "--labels", "--no-report"], ["task", plan, "label", 1, "-o", out]):
            done = ilot(*words)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.crs_of(out)["epsg"], 2994)
        self.assertEqual((out / "points/a.laz").read_bytes(), (one / "points/a.laz").read_bytes())

    def outlines(self, name, x, y, crs="urn:ogc:def:crs:EPSG::28992"):
        ring = [[x, y], [x + 12, y], [x + 12, y + 8], [x, y + 8], [x, y]]
        path = self.folder / name
        path.write_text(json.dumps({
            "type": "FeatureCollection", **({"crs": {"type": "name", "properties": {"name": crs}}} if crs else {}),
            "features": [{"type": "Feature", "properties": {"id": "house"},
                          "geometry": {"type": "Polygon", "coordinates": [ring]}}]}))
        return path

    def house(self):
        """Returns a gable roof of 12 x 8 m on flat ground around it, with classes 6 and 2."""
        points = [(300 * i, 300 * j, 3000 + round(0.5 * min(300 * j - 8000, 16000 - 300 * j)), 6)
                  for i in range(35, 73) for j in range(28, 53)]
        points += [(300 * i, 300 * j, 0, 2) for i in range(100) for j in range(80)
                   if not (33 <= i <= 75 and 26 <= j <= 55)]
        return small_las(self.folder / "house.las", points, offset=(85000, 447000, 0))

    def test_the_crs_of_footprints_is_taken_where_they_fit(self):
        cloud = self.house()
        out, run_json = self.work(cloud, "--products", "roofs", "--footprints", self.outlines("f.geojson", 85010, 447008))
        self.assertIn("EPSG:28992", [c["value"] for c in run_json["chosen"] if c["key"] == "crs"])
        self.assertIn("EPSG/0/28992", (out / "roofs" / "roofs.city.json").read_text())
        self.assertEqual(run_json["footprints"]["outside"], [])
        self.assertEqual(self.crs_of(out)["epsg"], 28992)
        both = json.loads((self.folder / "f.geojson").read_text())
        both["features"] += [{**f, "properties": {"id": f"far {i}"}} for i in range(5) for f in
                             json.loads(self.outlines("h.geojson", 85510, 447008).read_text())["features"]]
        (self.folder / "both.geojson").write_text(json.dumps(both))
        done = ilot("run", cloud, "-o", self.folder / "both", "--products", "roofs", "--footprints",
                    self.folder / "both.geojson")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("5 of 6 footprints are outside of the cloud's extent: far 0, far 1, far 2 and 2 more", done.stderr)
        self.assertEqual(done.stderr.count("skipped:"), 0)
        only = ilot("run", cloud, "-o", self.folder / "only", "--products", "roofs", "--crs", "EPSG:28992",
                    "--footprints", self.folder / "h.geojson")
        self.assertEqual(only.returncode, 3)
        self.assertRegex(only.stderr, r"none of 1 footprints is where the clouds are: the footprints are at x 85,510 to "
                         r"85,522, y 447,008 to 447,016, the clouds at x 85,000 to 85,030, y 447,000 to 447,024 "
                         r"\(both in EPSG:28992\)")
        self.assertIn("roofs    0 of 1 building with a model: ", only.stdout + only.stderr)
        far = ilot("run", cloud, "-o", self.folder / "no", "--products", "roofs", "--footprints",
                   self.outlines("g.geojson", 185010, 447008))
        self.assertEqual(far.returncode, 2)
        self.assertIn("are elsewhere", far.stderr)

    def test_areas_say_where_they_are(self):
        cloud = with_keys(small_las(self.folder / "a.las", slope(), offset=(651000, 6861000, 0)), [(1024, 1), (3072, 2154)])
        turned = ilot("run", cloud, "-o", self.folder / "no", "--bounds", "6861000,651000,6861010,651010")
        self.assertEqual(turned.returncode, 1)
        self.assertIn("with x and y exchanged", turned.stderr)
        # Lambert-93 651000 6861000 is at 2.33230 E, 48.84718 N
        ring = [[2.33, 48.846], [2.34, 48.846], [2.34, 48.85], [2.33, 48.85], [2.33, 48.846]]
        area = self.folder / "area.geojson"
        area.write_text(json.dumps({"type": "Polygon", "coordinates": [ring]}))
        out, run_json = self.work(cloud, "--within", area)
        self.assertEqual(run_json["counts"]["points"]["labelled"], 6400)
        self.assertTrue(any("--within" in w for w in run_json["warnings"]))
        nowhere = small_las(self.folder / "b.las", slope(), offset=(651000, 6861000, 0))
        done = ilot("run", nowhere, "-o", self.folder / "no", "--within", area)
        self.assertEqual(done.returncode, 2)
        self.assertIn("give it with --crs", done.stderr)

    def test_stations_need_no_steps(self):
        stations = self.folder / "stations.csv"
        stations.write_text("name,x,y,z\nA,-5,10,2\nB,25,10,2\n")
        cloud = small_las(self.folder / "a.las", slope())
        out, run_json = self.work(cloud, "--stations", stations)
        step = [c for c in run_json["chosen"] if c["key"] == "boundaries.step"]
        self.assertEqual(step[0]["value"], "neighbours")
        stations.write_text("A;-5;10;2\nB;25;10;2\n")
        self.work(cloud, "--stations", stations, "--set", "boundaries.step=neighbours")
        done = ilot("run", cloud, "-o", self.folder / "no", "--stations", stations, "--set", "boundaries.step=stations")
        self.assertEqual(done.returncode, 2)

    def test_info_says_what_a_cloud_suits(self):
        far = small_las(self.folder / "far.las", [(60000 * i, 60000 * j, 0) for i in range(10) for j in range(10)])
        output = ilot("info", far).stdout
        for product in ("planes", "roofs", "facades", "streets"):
            self.assertRegex(output, rf"{product} +no: ")
        self.assertIn("is the unit right?", output)
        same = small_las(self.folder / "same.las", [(5, 5, 5)] * 50)
        self.assertIn("all points are at one place", ilot("info", same).stdout)


class RealCoordinates(RunTest):
    def test_outlines_of_delft_without_a_model_are_no_fault(self):
        out, run_json = self.work(real("delft/ahn3_cropped_1.laz"), "--products", "roofs", "--no-clouds")
        self.assertEqual(run_json["skipped"], [])
        without = sum(run_json["clusters"]["without_model"].values())
        self.assertGreater(without, 0)
        self.assertEqual(without, run_json["counts"]["roofs"]["footprint_only"])

    def test_delft_takes_the_crs_and_its_obj_is_valid(self):
        out, run_json = self.work(real("delft/ahn3_cropped_1.laz"), "--products", "roofs", "--no-clouds", "--footprints",
                              real("delft/footprints.geojson"))
        self.assertIn("EPSG:28992", [c["value"] for c in run_json["chosen"] if c["key"] == "crs"])
        self.assertEqual(len(run_json["footprints"]["outside"]), 21)
        self.assertEqual(run_json["skipped"], [])
        for name in ("roofs.obj", "roofs.city.json"):
            done = ilot("validate", out / "roofs" / name)
            self.assertEqual(done.returncode, 0, done.stdout[-500:])


if __name__ == "__main__":
    main(synthetic=[CoordinatesTest], real=[RealCoordinates])
