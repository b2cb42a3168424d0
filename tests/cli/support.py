# SPDX-License-Identifier: Apache-2.0
"""Runs the command line from outside, on a cloud that is made by hand. ILOT_EXE names the program."""
import os
import pathlib
import struct
import subprocess
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


class CliCase(unittest.TestCase):
    """A new folder with a small cloud for each test, and what every refusal must look like."""
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
