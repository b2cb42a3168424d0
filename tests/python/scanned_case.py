# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python package share: a scanned cloud with its places, and calls that must be refused."""
import os
import pathlib
import subprocess
import tempfile
import unittest

import ilot

EXE = os.environ["ILOT_EXE"]


class ScannedCase(unittest.TestCase):
    POINTS = 20000

    @classmethod
    def setUpClass(cls):
        cls.room = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.room.name)
        cls.cloud = cls.folder / "cloud.laz"
        subprocess.run([EXE, "scan", "district", "-o", cls.cloud, "--points", str(cls.POINTS), "-q"], check=True)
        cls.points = ilot.read_cloud(cls.cloud)
        cls.places = cls.points["x"], cls.points["y"], cls.points["z"]

    @classmethod
    def tearDownClass(cls):
        cls.room.cleanup()

    def refused(self, words, function, *arguments, code=2, **keywords):
        with self.assertRaises(ilot.Error) as fault:
            function(*arguments, **keywords)
        self.assertEqual(fault.exception.code, code)
        self.assertIn(words, str(fault.exception))
