#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command line from outside: exit codes, one line per fault, nothing half-written. ILOT_EXE names the program."""
import json
import os
import pathlib
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import unittest

EXE = os.environ["ILOT_EXE"]


def las_file(path, points, declared=None):
    """LAS 1.2, point format 0, millimetres; points are (x, y, z, class)."""
    low = [min((p[i] for p in points), default=0) / 1000 for i in range(3)]
    high = [max((p[i] for p in points), default=0) / 1000 for i in range(3)]
    header = struct.pack("<4sHH16sBB32s32sHHHIIBHI5I", b"LASF", 0, 0, b"", 1, 2, b"test", b"test", 1, 2026, 227, 227, 0,
                         0, 20, len(points) if declared is None else declared, len(points), 0, 0, 0, 0)
    header += struct.pack("<12d", 0.001, 0.001, 0.001, 0, 0, 0, high[0], low[0], high[1], low[1], high[2], low[2])
    rows = b"".join(struct.pack("<iiiHBBbBH", x, y, z, 7, 0b001001, c, 0, 0, 1) for x, y, z, c in points)
    path.write_bytes(header + rows)
    return path


def ilot(*arguments, **options):
    return subprocess.run([EXE, *map(str, arguments)], capture_output=True, text=True, timeout=60, **options)


class Cli(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        grid = [(1000 * i, 1000 * j, 0, 2 if i < 30 else 6) for i in range(50) for j in range(40)]
        self.cloud = las_file(self.folder / "grid.las", grid)
        self.out = self.folder / "out"

    def tearDown(self):
        self.holder.cleanup()

    def refuse(self, arguments, *words, code=2):
        before = sorted(self.folder.rglob("*"))
        done = ilot(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stdout, "")
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertTrue(lines[0].startswith("ilot: "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(sorted(self.folder.rglob("*")), before, "nothing may be written")

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
        self.refuse([*scan, "--stations", self.folder / "none.csv"], "none.csv", code=1)
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

    def test_usage_faults_of_run(self):
        c, o = self.cloud, self.out
        self.refuse(["run"], "INPUT")
        self.refuse(["run", c], "-o OUT")
        self.refuse(["run", self.folder / "none.las", "-o", o], "none.las: no such file")
        self.refuse(["run", c, self.folder / "none.las", "-o", o], "none.las: no such file")
        self.refuse(["run", self.folder / "*.laz", "-o", o], "*.laz: no such file")
        self.refuse(["run", c, "-o", o, "--set", "planes.epsilom=1"], "unknown setting 'planes.epsilom'",
                    "nearest is 'planes.epsilon'")
        self.refuse(["run", c, "-o", o, "--set", "planes.epsilon=99"], "out of range: 0.0001 to 10 m")
        self.refuse(["run", c, "-o", o, "--set", "planes.epsilon"], "KEY=VALUE")
        self.refuse(["run", c, "-o", o, "--block-points", "5"], "256 to 67108864")
        self.refuse(["run", c, "-o", o, "--threads", "0"], "--threads")
        self.refuse(["run", c, "-o", o, "--memory", "lots"], "--memory lots")
        self.refuse(["run", c, "-o", o, "--memory", "1K"], "--memory")
        self.refuse(["run", c, "-o", o, "--memory", "2GiBs"], "--memory")
        self.refuse(["run", c, "-o", o, "--products", "gardens"], "gardens", "planes")
        self.refuse(["run", c, "-o", o, "--crs", "EPSG:x"], "EPSG:2154")
        self.refuse(["run", c, "-o", o, "--bounds", "1,2,3"], "X0,Y0,X1,Y1")
        self.refuse(["run", c, "-o", o, "--bounds", "0,0,1,1", "--within", "a"], "excludes")
        self.refuse(["run", c, "-o", o, "--within", self.folder / "none.json"], "cannot read the area")
        self.refuse(["run", c, "-o", o, "--resume", "--overwrite"], "excludes")
        self.refuse(["run", c, "-o", o, "-v", "-q"], "excludes")
        self.refuse(["run", c, "-o", o, "--log-json", "fd:99"], "fd:99")
        self.refuse(["run", c, "-o", o, "--log-json", "fd:x"], "fd:N")
        self.refuse(["run", c, "-o", o, "--config", self.folder / "none.toml"], "none.toml")
        self.refuse(["run", c, "-o", o, "--frobnicate"], "--frobnicate")

    def test_configuration_faults_name_the_place(self):
        config = self.folder / "ilot.toml"
        for text, place, word in [("[planes]\nepsilon = 20\n", ":2:11: ", "out of range"),
                                  ("[planes]\nepsilom = 1\n", ":2:1: ", "planes.epsilon"),
                                  ("[planes\n", ":1:", ""), ("seed = true\n", ":1:8: ", "whole number")]:
            config.write_text(text)
            self.refuse(["run", self.cloud, "-o", self.out, "--config", config], f"ilot.toml{place}", word)

    def test_other_usage_faults(self):
        self.refuse([], "no command")
        self.refuse(["frobnicate"], "frobnicate")
        self.refuse(["--json"], "--version")
        self.refuse(["info"], "INPUT")
        self.refuse(["info", self.folder / "none.las"], "no such file")
        self.refuse(["convert", self.cloud], "OUTPUT")
        self.refuse(["convert", self.folder / "none.las", self.folder / "a.las"], "no such file")
        self.refuse(["convert", self.cloud, self.cloud], "is the input itself")
        (self.folder / "empty").mkdir()
        self.refuse(["info", self.folder / "empty"], "contains no point cloud")

    def test_print_config_loads_back(self):
        first = ilot("run", "--print-config", "--set", "planes.epsilon=0.02", "--block-points", "65536")
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertIn("\nepsilon = 0.02\n", first.stdout)
        self.assertIn("\nblock_points = 65536\n", first.stdout)
        config = self.folder / "ilot.toml"
        config.write_text(first.stdout)
        self.assertEqual(ilot("run", "--print-config", "--config", config).stdout, first.stdout)
        over = ilot("run", "--print-config", "--config", config, "--set", "planes.epsilon=auto").stdout
        self.assertIn('\nepsilon = "auto"\n', over)

    def test_version_and_help(self):
        self.assertRegex(ilot("--version").stdout, r"^ilot \d+\.\d+\.\d+ \(\w+\)\n$")
        everything = json.loads(ilot("--version", "--json").stdout)
        for key in ("version", "git_hash", "compiler", "isa", "libraries"):
            self.assertTrue(everything[key], key)
        for command in ("run", "info", "convert", "scan", "evaluate", "render", "replay", "report", "validate", "view"):
            completed = ilot(command, "--help")
            self.assertEqual(completed.returncode, 0)
            self.assertIn(f"Example: ilot {command} ", completed.stdout)
            self.assertTrue(completed.stdout.endswith("\n"))
        for line in ilot("run", "--help").stdout.splitlines():
            if line.startswith("  -") and "--help" not in line:
                self.assertRegex(line, r"\[.+\]$", "every option says its default")

    def test_validate(self):
        good = ilot("convert", self.cloud, self.folder / "good.laz", "-q")
        self.assertEqual(good.returncode, 0, good.stderr)
        good = ilot("validate", self.folder / "good.laz", "-q")
        self.assertEqual((good.returncode, good.stderr), (0, ""))
        self.assertTrue(good.stdout.endswith("good.laz: valid\n"), good.stdout)
        short = las_file(self.folder / "short.las", [(0, 0, 0, 2)], declared=2)
        both = ilot("validate", short, self.folder / "good.laz", "-q")
        self.assertEqual(both.returncode, 1, both.stderr)
        self.assertIn("short.las: invalid: point-count: ", both.stdout)
        self.assertIn("good.laz: valid\n", both.stdout)
        (self.folder / "none.laz").write_bytes(b"LASF")
        self.assertIn("none.laz: invalid: unreadable: ", ilot("validate", self.folder / "none.laz").stdout)
        text = self.folder / "text.xyz"
        text.write_text("1 2 3\n")
        self.refuse(["validate", text], "no header to validate")
        self.refuse(["validate"], "FILE")

    def test_validate_models(self):
        corners = "".join(f"v {x} {y} {z}\n" for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
        walls = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n"
        closed = self.folder / "closed.obj"
        closed.write_text(corners + walls + "f 4 1 5 8\n")
        good = ilot("validate", closed)
        self.assertEqual((good.returncode, good.stderr), (0, ""))
        self.assertTrue(good.stdout.endswith("closed.obj: valid: 1 objects\n"), good.stdout)
        shed = self.folder / "shed.obj"
        shed.write_text("o shed\n" + corners + walls)
        both = ilot("validate", closed, shed)
        self.assertEqual(both.returncode, 1)
        self.assertIn("shed.obj: invalid: 302: shed: 302 SHELL_NOT_CLOSED near (0.000, 0.000, 0.000)\n", both.stdout)
        self.assertIn("shed.obj: invalid: 1 of 1 objects (302: 1)\n", both.stdout)
        completed = ilot("validate", "--json", closed, shed)
        self.assertEqual(completed.returncode, 1)
        report = json.loads(completed.stdout)
        self.assertFalse(report["valid"])
        self.assertEqual([f["codes"] for f in report["files"]], [{}, {"302": 1}])
        self.assertEqual(report["files"][1]["findings"][0]["faults"][0]["code"], 302)
        noise = self.folder / "noise.obj"
        for content in (bytes((i * i * 37 + i) % 251 for i in range(5000)), b"some words\nand more\n"):
            noise.write_bytes(content)
            other = ilot("validate", noise)
            self.assertEqual(other.returncode, 1, other.stdout)
            self.assertIn("noise.obj: invalid: 901", other.stdout)
        (self.folder / "broken.city.json").write_text("{")
        broken = ilot("validate", self.folder / "broken.city.json")
        self.assertEqual(broken.returncode, 1)
        self.assertIn("invalid: 901: 901 INVALID_INPUT_FILE ", broken.stdout)

    def test_info_measures(self):
        completed = ilot("info", self.cloud, "--json")
        self.assertEqual(completed.returncode, 0, completed.stderr)
        (one,) = json.loads(completed.stdout)
        self.assertEqual(one["points"], {"declared": 2000, "read": 2000, "rejected": 0})
        self.assertEqual(one["classes"], {"2": 1200, "6": 800})
        self.assertEqual(one["bounds"]["max"], [49.0, 39.0, 0.0])
        self.assertAlmostEqual(one["sampling_step_m"], 1)
        self.assertAlmostEqual(one["density_per_m2"]["all_returns"], 1, delta=0.2)
        self.assertTrue(one["suits"]["planes"]["yes"])
        self.assertIn("2,000", ilot("info", self.cloud).stdout)

    def test_widest_records_take_little_memory(self):
        wide = las_file(self.folder / "wide.las", [(0, 0, 0, 2)])
        data = bytearray(wide.read_bytes())
        struct.pack_into("<H", data, 105, 65535)
        wide.write_bytes(data.ljust(227 + 65535, b"\0"))
        for arguments in (["info", wide], ["validate", wide], ["convert", wide, self.folder / "copy.las"]):
            self.assertEqual(ilot(*arguments).returncode, 0, arguments)
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss  # KiB; sanitizers take their share
        self.assertLess(peak, 1 << 20)

    def test_info_of_good_and_bad(self):
        bad = self.folder / "bad.las"
        bad.write_bytes(b"not a cloud")
        self.refuse(["info", bad], "bad.las", code=1)
        both = ilot("info", bad, self.cloud, "--json")
        self.assertEqual(both.returncode, 3)
        self.assertEqual(len(json.loads(both.stdout)), 1)
        self.assertIn("bad.las", both.stderr)

    def test_convert_keeps_the_points(self):
        copy = self.folder / "copy.las"
        done = ilot("convert", self.cloud, copy, "-q")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(copy.read_bytes()[-20 * 2000:], self.cloud.read_bytes()[-20 * 2000:])
        self.refuse(["convert", self.cloud, copy], "--overwrite")
        self.assertEqual(ilot("convert", self.cloud, copy, "--overwrite").returncode, 0)
        self.refuse(["convert", self.cloud, self.folder / "copy.xyzzy"], "xyzzy", code=ilot(
            "convert", self.cloud, self.folder / "copy.xyzzy").returncode)
        self.refuse(["convert", self.cloud, self.folder / "none" / "copy.las", "-q"], "copy.las", code=1)

    def test_convert_salvages(self):
        short = las_file(self.folder / "short.las", [(0, 0, 0, 2), (1000, 0, 0, 2)], declared=5)
        done = ilot("convert", short, self.folder / "copy.las")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("3 of 5 points left out", done.stderr)

    def test_full_standard_output(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full here")
        with open("/dev/full", "w") as full:
            done = subprocess.run([EXE, "info", self.cloud], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output", done.stderr)

    def test_interrupted_leaves_nothing(self):
        def interrupted():  # pending from the first instruction on: the handler sees it at once
            signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT, signal.SIGTERM])
            os.kill(os.getpid(), signal.SIGINT)

        before = sorted(self.folder.rglob("*"))
        for arguments in (["convert", self.cloud, self.folder / "copy.las", "-q"], ["info", self.cloud, "-q"]):
            done = ilot(*arguments, preexec_fn=interrupted)
            self.assertEqual(done.returncode, 130, done.stderr)
            self.assertIn("interrupted", done.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before)


class Scan(unittest.TestCase):
    setUp, tearDown, refuse = Cli.setUp, Cli.tearDown, Cli.refuse

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
