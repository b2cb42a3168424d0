#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The plugin for QGIS, without a window. ILOT_EXE: the program. ILOT_NEED_QGIS=1: QGIS missing is a failure."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXE = os.environ["ILOT_EXE"]
QGIS = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
sys.path.insert(0, str(ROOT / "qgis/ilot"))

CANCELLED = """
import sys
from qgis.core import QgsApplication, QgsProcessingException, QgsProcessingFeedback
application = QgsApplication([], False)
application.initQgis()
sys.path[:0] = sys.argv[1:3]
from ilot import program

class Impatient(QgsProcessingFeedback):
    def setProgressText(self, text):
        if text == "planes":
            self.cancel()

arguments = ["run", sys.argv[3], "-o", sys.argv[4]]
try:
    print("code", program.run(arguments, Impatient(), events=True))
except QgsProcessingException as fault:
    print("fault", fault)
print("code", program.run(arguments + ["--resume"], QgsProcessingFeedback(), events=True))
"""


class SettingsTest(unittest.TestCase):
    def test_every_declared_setting_becomes_a_field(self):
        from settings import fields_of
        config = subprocess.run([EXE, "run", "--print-config"], capture_output=True, text=True, check=True).stdout
        fields = {f.key: f for f in fields_of(config)}
        self.assertEqual(len(fields), len(re.findall(r"^\w+ = ", config, re.M)))
        self.assertTrue(all(f.help for f in fields.values()))
        epsilon, method = fields["planes.epsilon"], fields["planes.method"]
        self.assertEqual((epsilon.kind, epsilon.minimum, epsilon.maximum, epsilon.unit, epsilon.optional),
                         ("number", 0.0001, 10, "m", True))
        self.assertIn("region_growing", method.choices)
        self.assertEqual((fields["roofs.trust_classes"].kind, fields["roofs.trust_classes"].default), ("boolean", "true"))
        self.assertEqual(fields["planes.curved"].kind, "boolean")
        self.assertEqual(fields["facades.sections"].kind, "text")
        self.assertTrue(fields["roofs.wall_cost"].advanced and not fields["roofs.detail"].advanced)


class ToolboxTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if QGIS is None:
            if os.environ.get("ILOT_NEED_QGIS"):
                raise AssertionError("qgis_process is missing: apt-get install qgis python3-qgis")
            print("SKIPPED: no qgis_process, so the toolbox of QGIS was not tried", file=sys.stderr)
            raise unittest.SkipTest("no qgis_process")
        cls.room = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.room.name)
        (cls.folder / "run").mkdir(mode=0o700)
        cls.environment = {**os.environ, "HOME": str(cls.folder), "QT_QPA_PLATFORM": "offscreen", "ILOT_EXECUTABLE": EXE,
                           "XDG_RUNTIME_DIR": str(cls.folder / "run"), "QGIS_PLUGINPATH": str(ROOT / "qgis"),
                           "PYTHONDONTWRITEBYTECODE": "1",
                           # QGIS takes the modules of the first python3 on the path; its own are those of the system.
                           "PATH": os.pathsep.join([str(pathlib.Path(QGIS).parent), os.environ["PATH"]])}
        cls.cloud = cls.folder / "town.laz"
        cls.call("plugins", "enable", "ilot")
        cls.call("run", "ilot:scan", "--", "SCENE=district", "POINTS=60000", f"OUTPUT={cls.cloud}")

    @classmethod
    def tearDownClass(cls):
        cls.room.cleanup()

    @classmethod
    def call(cls, *arguments, code=0):
        done = subprocess.run([QGIS, *arguments], env=cls.environment, capture_output=True, text=True, timeout=300)
        if done.returncode != code:
            raise AssertionError(f"{arguments}: {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def test_a_product_of_the_toolbox_is_that_of_the_program(self):
        text = self.call("run", "ilot:roofs", "--", f"INPUT={self.cloud}", "ROOFS_DETAIL=0.1", "ROOFS_SUPERSTRUCTURES=false",
                         "SETTINGS=planes.epsilon=0.05", f"OUTPUT={self.folder / 'roofs'}")
        subprocess.run([EXE, "run", self.cloud, "-o", self.folder / "program", "-q", "--products", "roofs", "--set",
                        "roofs.detail=0.1", "--set", "roofs.superstructures=false", "--set", "planes.epsilon=0.05"], check=True)
        hashes = [json.loads((self.folder / name / "run.json").read_text())["result_hash"] for name in ("roofs", "program")]
        self.assertEqual(hashes[0], hashes[1])
        self.assertIn("layer buildings: categorizedSymbol", text)
        self.assertIn("layer roof_faces", text)
        self.assertIn("report.html", text)
        again = self.call("run", "ilot:roofs", "--", f"INPUT={self.cloud}", f"OUTPUT={self.folder / 'roofs'}", code=1)
        self.assertIn("exists already", again)
        self.call("run", "ilot:report", "--", f"INPUT={self.folder / 'roofs'}", f"AGAINST={self.folder / 'program'}")

    def test_every_product_opens_its_layers(self):
        text = self.call("run", "ilot:planes", "--", f"INPUT={self.cloud}", "PLANES_METHOD=region_growing",
                         f"OUTPUT={self.folder / 'planes'}")
        self.assertIn("layer planes: graduatedSymbol", text)
        self.assertIn("planes.method=region_growing", text)
        street = self.folder / "street.laz"
        self.call("run", "ilot:scan", "--", "SCENE=street", "POINTS=150000", "SETTINGS=scene.blocks=2", f"OUTPUT={street}")
        text = self.call("run", "ilot:streets", "--", f"INPUT={street}", f"OUTPUT={self.folder / 'street'}")
        self.assertIn("layer objects: categorizedSymbol", text)
        self.call("run", "ilot:facades", "--", f"INPUT={street}", f"OUTPUT={self.folder / 'facades'}", "FACADES_SCALE=100")
        self.assertTrue(list(self.folder.glob("facades/facades/*.dxf")))

    def test_tools(self):
        self.assertTrue(self.cloud.with_suffix(".truth.json").exists())
        self.call("run", "ilot:info", "--", f"INPUT={self.cloud}", f"OUTPUT={self.folder / 'info.json'}")
        self.assertEqual(json.loads((self.folder / "info.json").read_text())[0]["points"]["read"], 60000)
        self.call("run", "ilot:convert", "--", f"INPUT={self.cloud}", f"OUTPUT={self.folder / 'town.ply'}")
        self.assertEqual((self.folder / "town.ply").read_bytes()[:3], b"ply")
        text = self.call("run", "ilot:info", "--", f"INPUT={self.folder / 'none.laz'}", f"OUTPUT={self.folder / 'n.json'}", code=1)
        self.assertIn("no such file", text)
        self.assertFalse((self.folder / "n.json").exists())

    def test_cancel_stops_the_run_and_it_can_be_resumed(self):
        done = subprocess.run(["/usr/bin/python3", "-c", CANCELLED, ROOT / "qgis", "/usr/share/qgis/python/plugins", self.cloud,
                               self.folder / "stopped"], env={**self.environment, "PYTHONPATH": ""}, capture_output=True, text=True)
        self.assertIn("fault Stopped", done.stdout, done.stderr)
        self.assertIn("code 0", done.stdout, done.stderr)

    def test_a_missing_program_is_named(self):
        environment = {**self.environment, "ILOT_EXECUTABLE": "", "PATH": "/nowhere"}
        done = subprocess.run([QGIS, "run", "ilot:info", "--", f"INPUT={self.cloud}", f"OUTPUT={self.folder / 'm.json'}"],
                              env=environment, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 1)
        self.assertIn("The program ilot was not found", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
