#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command line from outside: exit codes, one line per fault, nothing half-written. ILOT_EXE names the program."""
import json
import os
import resource
import signal
import struct
import subprocess
import sys
import unittest

from support import CliCase, EXE, ilot, las_file


class Cli(CliCase):
    def test_usage_faults_of_run(self):
        c, o = self.cloud, self.out
        self.refuse(["run"], "INPUT")
        self.refuse(["run", c], "-o OUT")
        self.refuse(["run", self.folder / "none.las", "-o", o], "none.las: no such file")
        self.refuse(["run", c, self.folder / "none.las", "-o", o], "none.las: no such file")
        self.refuse(["run", self.folder / "*.laz", "-o", o], "*.laz: no such file")
        self.refuse(["run", c, "-o", o, "--set", "planes.epsilom=1"], "unknown setting 'planes.epsilom'",
                    "did you mean 'planes.epsilon'?")
        self.refuse(["run", c, "-o", o, "--set", "planes.epsilon=99"], "out of range: 0.0001 to 10 m")
        self.refuse(["run", c, "-o", o, "--set", "planes.epsilon"], "KEY=VALUE")
        self.refuse(["run", c, "-o", o, "--block-points", "5"], "256 to 67108864")
        self.refuse(["run", c, "-o", o, "--threads", "0"], "--threads 0: a number from 1 to 1024 is expected")
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
        for option in ("--config", "--within", "--footprints", "--stations", "--train", "--edits"):
            self.refuse(["run", c, "-o", o, "--products", "planes,roofs,facades,streets", option, "none.x"], "none.x")
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

    def test_forced_instruction_set(self):
        for name in ("baseline", ""):
            done = ilot("--version", "--json", env={**os.environ, "ILOT_FORCE_ISA": name})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads(done.stdout)["isa"], name or json.loads(ilot("--version", "--json").stdout)["isa"])
        isas = json.loads(ilot("--version", "--json").stdout)["isas"]
        self.assertEqual(isas[0], "baseline")
        for name in ("avx3", "AVX2", "baseline "):
            done = ilot("info", self.cloud, env={**os.environ, "ILOT_FORCE_ISA": name})
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertRegex(done.stderr, rf"^ilot: ILOT_FORCE_ISA={name}: this machine has {', '.join(isas)}; name one.*\n$")

    def test_version_and_help(self):
        self.assertRegex(ilot("--version").stdout, r"^ilot \d+\.\d+\.\d+ \(\w+\)\n$")
        everything = json.loads(ilot("--version", "--json").stdout)
        for key in ("version", "git_hash", "compiler", "isa", "libraries"):
            self.assertTrue(everything[key], key)
        for command in ("run", "info", "convert", "scan", "evaluate", "render", "replay", "plan", "task", "merge", "report", "validate", "view"):
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
        self.assertTrue(good.stdout.endswith("closed.obj: valid: 1 object\n"), good.stdout)
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
        bent = self.folder / "bent.obj"  # one corner of the top 5 mm up: 1.25 mm from the least-squares plane
        bent.write_text(corners.replace("v 1 1 1", "v 1 1 1.005") + walls + "f 4 1 5 8\n")
        self.assertEqual(ilot("validate", bent).returncode, 0)
        self.assertIn("203: 1", ilot("validate", "--planarity", "0.001", "--snap", "0.0001", bent).stdout)
        self.assertIn("204: 1", ilot("validate", "--normals", "0.1", bent).stdout)
        self.refuse(["validate", "--planarity", "-1", bent], "--planarity")
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
        octree = self.folder / "small.copc.laz"
        little = ilot("convert", self.cloud, octree, "--memory", "1K", "-q")
        self.assertIn("ilot convert --memory", little.stderr)
        self.assertEqual((little.returncode, octree.exists()), (1, False))
        self.assertEqual(ilot("convert", self.cloud, copy, "--overwrite").returncode, 0)
        self.refuse(["convert", self.cloud, self.folder / "copy.xyzzy"], "xyzzy", code=ilot(
            "convert", self.cloud, self.folder / "copy.xyzzy").returncode)
        self.refuse(["convert", self.cloud, self.folder / "none" / "copy.las", "-q"], "copy.las", code=1)

    def test_compressed_files_are_to_be_unpacked(self):
        for magic, name in ((b"\x1f\x8b", "gzip"), (b"PK\x03\x04", "zip"), (b"7z\xbc\xaf\x27\x1c", "7-Zip")):
            for ending in ("xyz.gz", "xyz", "las"):
                path = self.folder / f"packed.{ending}"
                path.write_bytes(magic + bytes(100))
                self.refuse(["info", path], f"is compressed ({name}); unpack it first", code=1)

    def test_closing_lines_say_what_there_is(self):
        done = ilot("run", self.cloud, "-o", self.out, "--products", "planes,facades", "--no-report")
        self.assertEqual(done.returncode, 3, done.stderr)
        said = (done.stdout + done.stderr).splitlines()
        self.assertIn("facades  0 facades", said)
        self.assertIn(f"planes   1 plane: {self.out}/planes.gpkg", said)

    def test_resume_of_nothing_is_said(self):
        done = ilot("run", self.cloud, "-o", self.out, "--resume", "--no-report")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"ilot: {self.out}: holds no interrupted run that --resume could go on with; starts afresh",
                      done.stderr.splitlines())

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


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
