#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the program says to a user who is new to it: suggestions for what was mistyped, the end of a run, the manual, the
completion of shells and the state of the machine. ILOT_EXE names the program."""
import re
import shutil
import subprocess
import sys
import unittest

from support import CliCase, ilot

COMMANDS = ("run", "info", "convert", "scan", "draw", "edits", "export", "evaluate", "render", "replay", "plan", "task", "merge",
            "report", "validate", "view", "doctor", "manual", "completion")


class Manners(CliCase):
    def test_suggestions(self):
        c, o = self.cloud, self.out
        self.refuse(["rnu", c, "-o", o], "rnu: there is no such command; did you mean 'run'?")
        self.refuse(["pipeline.json"], "pipeline.json: there is no such command (ilot --help)")
        self.refuse(["--vresion"], "did you mean '--version'?")
        self.refuse(["run", c, "-o", o, "--product", "planes"], "did you mean '--products'?", "ilot run --help")
        self.refuse(["run", c, "-o", o, "--epsilon", "0.1"], "--set planes.epsilon=VALUE")
        self.refuse(["run", c, "-o", o, "--writers.las.filename=a.las"], "ilot run has no such option (ilot run --help)")
        self.refuse(["run", c, "-o", o, "--set", "epsilon=1"], "'planes.epsilon' or 'roofs.epsilon'")
        self.refuse(["run", c, "-o", o, "--set", "qqqqqqqqqq=1"], "ilot run --print-config")
        self.refuse(["run", c, "-o", o, "--products", "roof"], "did you mean 'roofs'?")
        self.refuse(["scan", "distrct", "-o", o], "did you mean 'district'?")
        self.refuse(["completion", "bsh"], "did you mean 'bash'?")
        self.refuse(["completion"], "no SHELL given")
        self.refuse(["run", c, "-o", o, "--memory"], "--memory: a value must follow (ilot run --help)")
        self.refuse(["draw", c, "-o", o], "broken JSON: parse error at line 1", code=1)

    def test_a_run_ends_with_what_to_open(self):
        done = ilot("run", self.cloud, "-o", self.out, "--no-clouds")
        self.assertEqual(done.returncode, 0, done.stderr)
        *_, planes, everything, last = done.stderr.splitlines()
        self.assertRegex(planes, rf"^planes +\d+ planes?: {re.escape(str(self.out))}/planes\.gpkg$")
        self.assertRegex(everything, r"^all +2,000 points, \d+ seconds?, peak \d+ MiB$")
        self.assertEqual(last, f"open {self.out}/report.html")
        for line in (planes, last):
            self.assertTrue((self.out / line.rsplit("/", 1)[1]).is_file(), line)
        without = ilot("run", self.cloud, "-o", self.out, "--overwrite", "--no-report").stderr
        self.assertNotIn("open ", without)

    def test_numbers_agree_with_nouns(self):
        done = ilot("run", self.cloud, "-o", self.out, "--dry-run", "--threads", "1")
        self.assertIn("from 1 file into", done.stderr)
        self.assertIn("on 1 thread,", done.stderr)

    def test_doctor(self):
        done = ilot("doctor", self.folder, "--quick")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for word in ("version", "cores", "instructions", "memory", "disk", "CRS database"):
            self.assertIn(f"\n  {word} ", done.stdout)
        self.assertTrue(done.stdout.endswith("\nnothing is missing\n"))
        whole = ilot("doctor", self.folder)
        self.assertIn(whole.returncode, (0, 3), whole.stderr)
        self.assertRegex(whole.stdout, r"\n  run +[\d.]+ s, .* points/s\n")
        self.assertEqual([p.name for p in self.folder.iterdir()], ["grid.las"])
        self.refuse(["doctor", self.folder / "none"], "is no folder")

    def test_manual_has_all_commands_and_options(self):
        page = ilot("manual").stdout
        self.assertTrue(page.startswith(".TH ILOT 1 "))
        for command in COMMANDS:
            self.assertIn(f'.SS "ilot {command}"', page)
            for option in re.findall(r"^  (?:-\w,)?(--[\w-]+)", ilot(command, "--help").stdout, re.M):
                self.assertIn(option.replace("-", r"\-"), page)
        self.assertIn(r"\fBplanes.epsilon\fR [", page)
        if shutil.which("man"):
            shown = subprocess.run(["man", "--warnings", "-l", "-"], input=page, capture_output=True, text=True,
                                   env={"MANWIDTH": "80", "LC_ALL": "C.UTF-8", "PATH": "/usr/bin:/bin"})
            self.assertEqual((shown.returncode, shown.stderr), (0, ""))

    def test_bash_completes(self):
        script = self.folder / "ilot.bash"
        script.write_text(ilot("completion", "bash").stdout)
        def completed(*words):
            line = " ".join(f"'{w}'" for w in words)
            done = subprocess.run(["bash", "-c", f"compopt() {{ :; }}; . {script}; COMP_WORDS=({line}); "
                                   f"COMP_CWORD={len(words) - 1}; _ilot; printf '%s\\n' \"${{COMPREPLY[@]}}\""],
                                  capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            return done.stdout.split()
        self.assertEqual(completed("ilot", "ru"), ["run"])
        self.assertEqual(completed("ilot", "run", "--prod"), ["--products"])
        self.assertEqual(completed("ilot", "run", "--products", "ro"), ["roofs"])
        self.assertEqual(completed("ilot", "run", "--set", "planes.epsilon_"), ["planes.epsilon_by="])
        self.assertTrue(set(COMMANDS) <= set(completed("ilot", "")))

    def test_other_shells(self):
        for shell in ("zsh", "fish"):
            text = ilot("completion", shell).stdout
            for word in (*COMMANDS, "products", "planes.epsilon="):
                self.assertIn(word, text)
            if shutil.which(shell):
                script = self.folder / shell
                script.write_text(text)
                self.assertEqual(subprocess.run([shell, "-n", script]).returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
