#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scanning, evaluating and drawing from outside: the same bytes for any threads, and what is refused. ILOT_EXE names the program."""
import json
import sys
import unittest

from support import CliCase, ilot


class Scan(CliCase):
    def test_scans_of_models(self):
        model = self.folder / "box.obj"
        model.write_text("mtllib gone.mtl\n" + "".join(f"v {x} {y} {z}\n" for z in (0, 5) for y in (0, 8) for x in (0, 9)) +
                         "f -8 -7 -3 -4\nf -7 -5 -1 -3\nf -5 -6 -2 -1\nf -6 -8 -4 -2\nf -4 -3 -1 -2\n")
        cloud = self.folder / "box.las"
        scan = ["scan", "--model", model, "-o", cloud]
        self.refuse(["scan", "--model", model], "-o FILE")
        self.refuse(["scan", "stones", "-o", cloud, "--flight"], "--model")
        self.refuse(["scan", "stones", *scan[1:]], "contradict")
        self.refuse(["scan", "--model", self.folder / "none.obj", "-o", cloud], "no such file")
        self.refuse([*scan, "--unit", "furlong"], "us-ft")
        self.refuse([*scan, "--unit", "mm"], "--unit", code=1)
        self.refuse([*scan, "--set", "scene.glass_nothing=1"], "above 1")
        self.refuse([*scan, "--stations", self.folder / "none.csv"], "none.csv: there is no such file")
        places = self.folder / "far.csv"
        places.write_text("a,9e6,9e6,2\n")
        self.refuse([*scan, "--vehicle", places], "far from the model")
        places.write_text("a,4,-9,2\n")
        self.refuse([*scan, "--vehicle", places], "two places")
        done = ilot(*scan, "--stations", "--vehicle", "--flight", "--points", 5000)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("stations placed", done.stderr)
        self.refuse(scan, "--overwrite")
        truth = json.loads((self.folder / "box.truth.json").read_text())
        self.assertEqual(sorted({p["class"] for p in truth["planes"]}), ["facade", "ground", "roof"])
        done = ilot(*scan, "--stations", places, "--overwrite", "-q")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(len(json.loads((self.folder / "box.truth.json").read_text())["stations"]), 1)

    def test_usage_faults(self):
        town = self.folder / "town.las"
        self.refuse(["scan"], "SCENE")
        self.refuse(["scan", "village", "-o", town], "village", "--list")
        self.refuse(["scan", "district"], "-o FILE")
        self.refuse(["scan", "district", "-o", town, "--set", "scene.densty=2"], "scene.density")
        self.refuse(["scan", "district", "-o", town, "--set", "scene.density=2000"], "0.1 to 200")
        self.refuse(["scan", "district", "-o", town, "--points", "0"], "--points")
        self.refuse(["scan", "district", "-o", self.cloud, "--points", "1000"], "grid.las: exists", "--overwrite")
        self.refuse(["scan", "district", "-o", self.folder / "town.xyzzy", "-q"], "xyzzy")
        self.refuse(["evaluate"], "OUT")
        self.refuse(["evaluate", self.cloud], "--truth FILE", "--truth-fields")
        self.refuse(["evaluate", self.cloud, "--truth-fields"], "true_plane", code=1)
        self.refuse(["render", self.cloud], "-o FILE")
        self.refuse(["render", self.cloud, "-o", self.folder / "a.png", "--by", "plane_id"], "plane_id", "height")
        self.refuse(["render", self.cloud, "-o", self.folder / "a.png", "--bounds", "9,9,1,1"], "X0 < X1")
        self.refuse(["render", self.cloud, "-o", self.folder / "no" / "a.png"], "a.png", code=1)
        self.refuse(["render", self.cloud, "-o", self.folder / "a.gif"], "a.gif: pictures are written as PNG")

    def test_pictures_of_colours_of_8_and_16_bits_are_equal(self):
        """Many writers leave 8 bits a channel in LAS's fields of 16."""
        pictures = []
        for step in (1, 256):
            rows = [b"%d %d 0 %d %d %d\n" % (x, y, step * (5 * x + 20), step * 100, step * (5 * y + 20))
                    for x in range(40) for y in range(40)]
            cloud = self.folder / f"{step}.las"
            text = self.folder / f"{step}.csv"
            text.write_bytes(b"x y z red green blue\n" + b"".join(rows))
            self.assertEqual(ilot("convert", text, cloud).returncode, 0)
            picture = self.folder / f"{step}.png"
            self.assertEqual(ilot("render", cloud, "-o", picture, "--by", "rgb", "--size", "100").returncode, 0)
            pictures.append(picture.read_bytes())
        self.assertEqual(*pictures)
        self.assertEqual(ilot("render", cloud, "-o", self.folder / "a.PNG", "--size", "100").returncode, 0)

    def test_scan_evaluate_render(self):
        town = self.folder / "town.las"
        done = ilot("scan", "district", "-o", town, "--points", "30000", "--threads", "1")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertIn("30000 points", done.stderr)
        other = self.folder / "other.las"
        ilot("scan", "district", "-o", other, "--points", "30000", "--threads", "3", "-q")
        self.assertEqual(town.read_bytes(), other.read_bytes())
        truth = json.loads((self.folder / "town.truth.json").read_text())
        self.assertEqual(truth["points"], 30000)
        judged = json.loads(ilot("evaluate", town, "--truth-fields", "--found-field", "true_plane", "--json").stdout)
        self.assertEqual(judged["planes"]["missed"], 0)
        self.assertEqual(judged["points"]["share"], 1)
        self.assertIn("100.000 %", ilot("evaluate", town, "--truth-fields", "--found-field", "true_plane").stdout)
        for view in ("top", "oblique", "side"):
            drawn = ilot("render", town, "-o", self.folder / f"{view}.png", "--view", view, "--size", "200")
            self.assertEqual(drawn.returncode, 0, drawn.stderr)
            self.assertEqual((self.folder / f"{view}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertIn("scene.density", ilot("scan", "--list").stdout)

    def test_evaluate_usage_faults(self):
        truth, model = self.folder / "t.truth.json", self.folder / "a.obj"
        truth.write_text('{"planes": [{"id": 1}]}')
        model.write_text("v 0 0 0\nv 9 0 0\nv 9 9 0\nf 1 2 4\n")
        e, c = "evaluate", self.cloud
        self.refuse([e, c, "--truth", truth, "--truth-fields"], "--truth FILE", "--truth-fields")
        self.refuse([e, c, "--truth", self.folder / "none.json"], "none.json: no such file")
        self.refuse([e, c, "--truth", truth], "t.truth.json.planes[0]: 'plane' is missing", code=1)
        truth.write_text("{}")
        self.refuse([e, self.folder / "none", "--truth", truth], "none: no such file or folder")
        self.refuse([e, c, "--truth", truth], "grid.las: nothing to judge", code=1)
        (self.folder / "empty").mkdir()
        self.refuse([e, self.folder / "empty", "--truth", truth], "points/")
        self.refuse([e, c, "--truth", truth, "--match", "best"], "--match")
        self.refuse([e, "--models", model], "--cloud FILE")
        self.refuse([e, "--cloud", c], "--models FILE")
        self.refuse([e, c, "--models", model, "--cloud", c], "--cloud alone")
        self.refuse([e, "--models", model, "--cloud", c], "a.obj:4: a face names vertex 4 of 3", code=1)
        self.refuse([e, "--models", self.folder / "none.obj", "--cloud", c], "none.obj: no such file")
        self.refuse([e, "--models", c, "--cloud", c], "not a model that can be read")
        model.write_text("")
        self.refuse([e, "--models", model, "--cloud", c], "contains no model", code=1)
        model.write_text("o a\nv -90 0 0\nv -91 0 0\nv -91 9 0\nf 1 2 3\no b\nf 3 2 1\n")
        self.refuse([e, "--models", model, "--cloud", c], "same coordinate system", code=1)
        self.refuse([e, "--models", model, "--cloud", c, "--points-of", "field"], "no extra bytes 'building'", code=1)

    def test_evaluate_a_run(self):
        town, page = self.folder / "town.las", self.folder / "page.html"
        ilot("scan", "district", "-o", town, "--points", "30000", "-q")
        self.assertEqual(ilot("run", town, "-o", self.out, "-q").returncode, 0)
        truth = self.folder / "town.truth.json"
        judged = ilot("evaluate", self.out, "--truth", truth, "--json", "--html", page)
        self.assertEqual(judged.returncode, 0, judged.stderr)
        figures = json.loads(judged.stdout)
        self.assertEqual(figures["planes"]["matched"] + figures["planes"]["missed"], figures["planes"]["true"])
        self.assertLess(figures["planes"]["angle_deg"], 1)
        self.assertIn("roof", figures["confusion"]["classes"])
        self.assertGreater(figures["confusion"]["global_sensitivity"], 0.5)
        self.assertTrue(page.read_text().startswith("<section"))
        self.assertIn("sensitivity", ilot("evaluate", self.out, "--truth", truth).stdout)

    def test_evaluate_models(self):
        model = self.folder / "m.obj"
        model.write_text("o flat\nv 0 0 0\nv 49 0 0\nv 49 39 0\nv 0 39 0\nf 1 2 3 4\n")
        completed = ilot("evaluate", "--models", model, "--cloud", self.cloud, "--json")
        self.assertEqual(completed.returncode, 0, completed.stderr)
        figures = json.loads(completed.stdout)
        self.assertEqual(figures["points"], {"read": 2000, "judged": 2000, "unassigned": 0})
        self.assertEqual(figures["over_points"]["rmse_m"], 0)
        some = json.loads(ilot("evaluate", "--models", model, "--cloud", self.cloud, "--json", "--class", "6").stdout)
        self.assertEqual(some["points"]["read"], 800)
        self.assertIn("share within 0.2 m", ilot("evaluate", "--models", model, "--cloud", self.cloud).stdout)

    def test_scan_from_a_tripod(self):
        listed = ilot("scan", "--list").stdout
        for scene in ("stones", "facade-restoration", "facade-haussmann", "building", "shapes"):
            self.assertIn("\n" + scene + " ", "\n" + listed)
            paths = [self.folder / f"{scene}-{threads}.las" for threads in (1, 3)]
            for path, threads in zip(paths, (1, 3)):
                done = ilot("scan", scene, "-o", path, "--points", "20000", "--threads", threads)
                self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
            self.assertEqual(paths[0].read_bytes(), paths[1].read_bytes())
            truths = [path.with_suffix(".truth.json").read_text() for path in paths]
            self.assertEqual(truths[0], truths[1])
            truth = json.loads(truths[0])
            self.assertEqual(truth["scan"]["scene"], scene)
            self.assertAlmostEqual(truth["counts"]["points"], 20000, delta=600)
            info = json.loads(ilot("info", paths[0], "--json").stdout)
            self.assertIn(str(truth["counts"]["points"]), json.dumps(info))
            for by in ("rgb", "true_class", "true_plane", "true_element", "intensity"):
                drawn = ilot("render", paths[0], "-o", self.folder / "a.png", "--by", by, "--view", "side", "--size", "100")
                self.assertEqual(drawn.returncode, 0, drawn.stderr)
        self.refuse(["scan", "stones", "-o", self.folder / "s.las", "--set", "scene.joint_depht=1"], "scene.joint_depth")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
