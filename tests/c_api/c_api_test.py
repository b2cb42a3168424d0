#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The C interface of an installation, from C and from ctypes. ILOT_PREFIX: where it is installed. ILOT_EXE: the program with
which it is compared."""
import ctypes
import json
import os
import pathlib
import re
import subprocess
import tempfile
import threading
import unittest

EXE, PREFIX = os.environ["ILOT_EXE"], pathlib.Path(os.environ["ILOT_PREFIX"])
HERE = pathlib.Path(__file__).resolve().parent
HEADER = PREFIX / "include/ilot/ilot.h"
PC = next(PREFIX.glob("lib*/**/pkgconfig/ilot.pc"))
LIBRARY = PC.parents[1] / "libilot.so.1"
OK, FAILED, USAGE, INTERRUPTED = 0, 1, 2, 130
PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_uint64, ctypes.c_uint64, ctypes.c_double)


def declared():
    return set(re.findall(r"\b(ilot_\w+)\(", re.sub(r"/\*.*?\*/", "", HEADER.read_text(), flags=re.S)))


class CInterface(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.room = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.room.name)
        cls.cloud = cls.folder / "town.laz"
        subprocess.run([EXE, "scan", "district", "-o", cls.cloud, "--points", "60000", "-q"], check=True)
        cls.ilot = ctypes.CDLL(LIBRARY)
        cls.ilot.ilot_last_error.restype = ctypes.c_char_p
        cls.ilot.ilot_run_new.restype = ctypes.c_void_p
        cls.ilot.ilot_cloud_rows.restype = ctypes.c_uint64

    @classmethod
    def tearDownClass(cls):
        cls.room.cleanup()

    def said(self):
        return self.ilot.ilot_last_error().decode()

    def text(self, function, *arguments):
        """What a function gives as JSON."""
        given = ctypes.c_void_p()
        self.assertEqual(function(*arguments, ctypes.byref(given)), OK, self.said())
        value = json.loads(ctypes.string_at(given.value))
        self.ilot.ilot_free(given)
        return value

    def run_of(self, output, **options):
        run = ctypes.c_void_p(self.ilot.ilot_run_new())
        self.assertEqual(self.ilot.ilot_run_add_input(run, os.fsencode(self.cloud)), OK)
        for name, value in {"output": str(output), **options}.items():
            self.assertEqual(self.ilot.ilot_run_set_option(run, name.encode(), value.encode()), OK, self.said())
        return run

    def test_c_programs_are_built_against_the_installation(self):
        flags = subprocess.run(["pkg-config", "--cflags", "--libs", "ilot"], capture_output=True, text=True, check=True,
                               env={**os.environ, "PKG_CONFIG_PATH": str(PC.parent)}).stdout.split()
        for source, arguments in ((HERE / "faults.c", [self.folder / "three.laz"]),
                                  (HERE.parents[1] / "examples/c_interface.c", [self.cloud, self.folder / "example"])):
            program = self.folder / source.stem
            subprocess.run(["cc", "-std=c99", "-D_POSIX_C_SOURCE=200809L", "-Wall", "-Wextra", "-Wpedantic", "-Werror", source,
                            *flags, "-lm", "-o", program], check=True)
            done = subprocess.run([program, *arguments], capture_output=True, text=True,
                                  env={**os.environ, "LD_LIBRARY_PATH": str(LIBRARY.parent)})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("of JSON", done.stdout)

    def test_the_library_shows_what_the_header_declares_and_no_more(self):
        listed = subprocess.run(["nm", "-D", "--defined-only", LIBRARY], capture_output=True, text=True, check=True).stdout
        shown = {line.split()[2].split("@")[0] for line in listed.splitlines()} - {"ILOT_1"}
        self.assertEqual(shown, declared())
        released = set((HERE / "exports.txt").read_text().split())
        self.assertEqual(released - shown, set(), "a released function never goes")
        self.assertEqual(shown - released, set(), "a new function is named in exports.txt")
        dynamic = subprocess.run(["readelf", "-d", LIBRARY], capture_output=True, text=True, check=True).stdout
        self.assertIn("[libilot.so.1]", dynamic)

    def test_runs_are_those_of_the_program(self):
        subprocess.run([EXE, "run", self.cloud, "-o", self.folder / "program", "-q", "--products", "planes,roofs", "--set",
                        "roofs.detail=0.1", "--no-report"], check=True)
        run = self.run_of(self.folder / "c", products="planes,roofs", memory_bytes=str(512 << 20), threads="1")
        self.assertEqual(self.ilot.ilot_run_set(run, b"roofs.detail=0.1"), OK)
        stages = set()
        note = PROGRESS(lambda user, stage, *rest: stages.add(stage.decode()) or 0)
        self.ilot.ilot_run_set_callbacks(run, note, None, None)
        self.assertEqual(self.ilot.ilot_run_start(run), OK, self.said())
        self.assertIn("roofs", stages)
        self.assertEqual(self.ilot.ilot_run_start(run), USAGE, "the folder exists now")
        self.assertIn("exists already", self.said())
        self.ilot.ilot_run_free(run)
        record = self.text(self.ilot.ilot_read_run, os.fsencode(self.folder / "c"))
        truth = json.loads((self.folder / "program/run.json").read_text())
        self.assertEqual(record["result_hash"], truth["result_hash"])
        self.check_results(self.folder / "c")

    def check_results(self, folder):
        rows = (folder / "planes.csv").read_text().splitlines()
        planes = self.text(self.ilot.ilot_read_planes, os.fsencode(folder))
        self.assertEqual([p["id"] for p in planes], list(range(1, len(rows))))
        self.assertEqual(sum(len(p["outline"]) > 0 for p in planes), sum(p["area_m2"] > 0 for p in planes))
        buildings = self.text(self.ilot.ilot_read_roofs, os.fsencode(folder))
        solids = [level for b in buildings for level in b["levels"] if level["lod"] == "2.2"]
        self.assertGreater(len(solids), 0)
        for solid in solids:
            corners = [i for s in solid["surfaces"] for ring in s["rings"] for i in ring]
            self.assertGreater(len(corners), 0)
            self.assertLess(max(corners), len(solid["vertices"]))

    def test_facades_and_streets_are_read_back(self):
        front = self.folder / "front.laz"
        subprocess.run([EXE, "scan", "facade-restoration", "-o", front, "--points", "60000", "-q"], check=True)
        subprocess.run([EXE, "run", front, "-o", self.folder / "front", "-q", "--products", "facades,streets", "--no-report"])
        facades = self.text(self.ilot.ilot_read_facades, os.fsencode(self.folder / "front"))
        stored = json.loads((self.folder / "front/facades/facade-001.json").read_text())
        self.assertEqual(len(facades[0]["elements"]), len(stored["elements"]))
        streets = self.text(self.ilot.ilot_read_streets, os.fsencode(self.folder / "front"))
        self.assertEqual(set(streets), {"objects", "blocks", "gaps", "trees", "kerbs", "widths", "pavements", "carriageways"})

    def test_a_stop_ends_one_run_and_not_that_which_waits(self):
        statuses = {}
        begun = threading.Event()

        def second():
            run = self.run_of(self.folder / "waits")
            begun.set()
            statuses["waits"] = self.ilot.ilot_run_start(run)
            self.ilot.ilot_run_free(run)
        other = threading.Thread(target=second)

        def stop_when_the_other_waits(user, stage, *rest):
            if not begun.is_set():
                other.start()
                begun.wait()
            return int(stage == b"planes")
        stop = PROGRESS(stop_when_the_other_waits)
        run = self.run_of(self.folder / "first")
        self.ilot.ilot_run_set_callbacks(run, stop, None, None)
        self.assertEqual(self.ilot.ilot_run_start(run), INTERRUPTED)
        other.join()
        self.assertEqual(statuses["waits"], OK)
        self.ilot.ilot_run_free(run)

    def test_a_facade_that_was_corrected(self):
        """A window that was moved by hand has no stated error; its neighbours keep theirs."""
        front = self.folder / "corrected.laz"
        subprocess.run([EXE, "scan", "facade-restoration", "-o", front, "--points", "60000", "-q"], check=True)
        made = self.folder / "uncorrected"
        subprocess.run([EXE, "run", front, "-o", made, "-q", "--products", "facades", "--no-report", "--no-clouds"], check=True)
        plan = json.loads((made / "facades/facade-001.json").read_text())
        window = next(e for e in plan["elements"] if e["kind"] == "window" and len(e["ring"]) == 4)
        row = {"product": "facades", "edit": "moved", "kind": "window"}
        for number, corner in ((1, window["ring"][0]), (2, window["ring"][2])):
            for k, axis in enumerate("xyz"):
                row[f"{axis}{number}"] = corner[k]
                row[f"to_{axis}{number}"] = corner[k] + 0.2 * plan["frame"]["right"][k]
        table = self.folder / "edits.csv"
        table.write_text(",".join(row) + "\n" + ",".join(map(str, row.values())) + "\n")
        run = ctypes.c_void_p(self.ilot.ilot_run_new())
        self.assertEqual(self.ilot.ilot_run_add_input(run, os.fsencode(front)), OK)
        for name, value in {"output": str(self.folder / "byhand"), "products": "facades", "edits": str(table), "clouds": "false"}.items():
            self.assertEqual(self.ilot.ilot_run_set_option(run, name.encode(), value.encode()), OK, self.said())
        self.assertEqual(self.ilot.ilot_run_start(run), OK, self.said())
        self.ilot.ilot_run_free(run)
        facade = self.text(self.ilot.ilot_read_facades, os.fsencode(self.folder / "byhand"))[0]
        hand = [e for e in facade["elements"] if e["status"] == "by hand"]
        self.assertEqual(len(hand), 1)
        moved = {edge["status"] for edge in hand[0]["edges"] if edge["error_m"] is None}
        self.assertEqual(moved, {"by hand"})
        self.assertAlmostEqual(hand[0]["width_m"], window["width_m"], 6)
        self.assertTrue(all(edge["error_m"] > 0 for e in facade["elements"] if e["status"] == "seen" for edge in e["edges"]))

    def test_a_callback_stops_the_run_and_it_can_be_resumed(self):
        stop = PROGRESS(lambda user, stage, *rest: int(stage == b"planes"))
        run = self.run_of(self.folder / "stopped")
        self.ilot.ilot_run_set_callbacks(run, stop, None, None)
        self.assertEqual(self.ilot.ilot_run_start(run), INTERRUPTED)
        self.assertIn("resume", self.said())
        self.assertFalse((self.folder / "stopped/run.json").exists())
        self.ilot.ilot_run_set_callbacks(run, None, None, None)
        self.assertEqual(self.ilot.ilot_run_set_option(run, b"existing", b"resume"), OK)
        self.assertEqual(self.ilot.ilot_run_start(run), OK, self.said())
        self.ilot.ilot_run_free(run)

    def test_parameters_are_those_of_the_program(self):
        listed = self.text(self.ilot.ilot_parameters)
        config = subprocess.run([EXE, "run", "--print-config"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(len(listed), len(re.findall(r"^\w+ = ", config, re.M)))
        self.assertTrue(all(p["help"] for p in listed))

    def test_every_thread_has_its_own_last_error(self):
        cloud = ctypes.c_void_p()
        self.assertEqual(self.ilot.ilot_cloud_open(b"/nowhere/one.laz", ctypes.byref(cloud)), FAILED)
        others = []
        other = threading.Thread(target=lambda: others.append(self.said()))
        other.start()
        other.join()
        self.assertEqual(others, [""])
        self.assertIn("one.laz", self.said())


if __name__ == "__main__":
    unittest.main()
