#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands of docs/guide as a reader would, page by page, and looks for the messages that it explains in the
sources. ILOT_EXE names the program."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
GUIDE = ROOT / "docs" / "guide"
EXE = os.environ["ILOT_EXE"]
COMMANDS = re.compile(r"^```sh\n(.*?)^```$", re.S | re.M)
SETTING = re.compile(r"`(?:--set )?((?:planes|roofs|facades|streets|classes|index|boundaries)\.(?!csv|gpkg|html|md|laz)\w+)(?:=[^`]*)?`")


def commands_of(page):
    return "".join(COMMANDS.findall((GUIDE / page).read_text()))


class Guide(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.clouds = pathlib.Path(cls.holder.name) / "clouds"
        cls.programs = pathlib.Path(cls.holder.name) / "bin"
        for folder in (cls.clouds, cls.programs):
            folder.mkdir()
        (cls.programs / "ilot").symlink_to(EXE)
        cls.follow("README.md", cls.clouds)

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    @classmethod
    def follow(cls, page, folder):
        environment = {**os.environ, "PATH": f"{cls.programs}:{os.environ['PATH']}"}
        done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", commands_of(page)], cwd=folder, capture_output=True,
                              text=True, timeout=500, env=environment)
        if done.returncode != 0:
            raise AssertionError(f"{page}: exit {done.returncode}\n{done.stderr[-2000:]}")

    def test_pages(self):
        pages = sorted(p.name for p in GUIDE.glob("*.md") if p.name != "README.md" and commands_of(p.name))
        self.assertGreaterEqual(len(pages), 6)
        for page in pages:
            with self.subTest(page), tempfile.TemporaryDirectory(dir=self.holder.name) as name:
                folder = pathlib.Path(name)
                for cloud in self.clouds.iterdir():
                    (folder / cloud.name).symlink_to(cloud)
                self.follow(page, folder)

    def test_readme_lists_all_pages(self):
        contents = (GUIDE / "README.md").read_text()
        for page in GUIDE.glob("*.md"):
            if page.name != "README.md":
                self.assertIn(f"({page.name})", contents)

    def test_settings_exist(self):
        known = subprocess.run([EXE, "run", "--print-config"], capture_output=True, text=True, check=True).stdout
        section, keys = "", set()
        for line in known.splitlines():
            if line.startswith("["):
                section = line.strip("[]")
            elif match := re.match(r"(\w+) = ", line):
                keys.add(f"{section}.{match.group(1)}")
        for page in GUIDE.glob("*.md"):
            for key in SETTING.findall(page.read_text()):
                self.assertIn(key, keys, page.name)

    def test_messages_are_in_the_sources(self):
        sources = "\n".join(path.read_text() for top in ("engine", "tools", "scan") for path in (ROOT / top).rglob("*.cpp"))
        sources = re.sub(r'"\s*\n\s*"', "", sources)  # literals that go on in the next line
        table = (GUIDE / "troubleshooting.md").read_text().split("## By message")[1].split("## Questions")[0]
        messages = re.findall(r"^\| `([^`]+)` \|", table, re.M)
        self.assertGreater(len(messages), 15)
        for message in messages:
            self.assertIn(message, sources)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
