#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`ilot export --to ifc` of facades, read back by npm's web-ifc below ILOT_NPM and compared with the plan and its DXF. ILOT_EXE
names the program."""
import json
import pathlib
import tempfile
import unittest

import export_readers as readers
from export_support import must, npm_has, seen_in_ifc


def ring_area(ring, right, up):
    places = [(readers.dot(p, right), readers.dot(p, up)) for p in (readers.minus(q, ring[0]) for q in ring)]
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(places, places[1:] + places[:1])) / 2


def schedule_of(path):
    """id -> (width, height) of the openings in a DXF: the attributes of its blocks."""
    lines = path.read_text().splitlines()
    sizes, entity, attribute, all_of = {}, "", {}, {}
    for code, text in zip(lines[::2], lines[1::2]):
        code = int(code)
        if code == 0:
            if entity == "ATTRIB":
                all_of[attribute.get(2)] = attribute.get(1)
            if entity == "ATTRIB" and text != "ATTRIB" and "ID" in all_of:
                sizes[int(all_of["ID"])] = (float(all_of["WIDTH"]), float(all_of["HEIGHT"]))
                all_of = {}
            entity, attribute = text, {}
        attribute[code] = text
    return sizes


@unittest.skipUnless(npm_has("web-ifc"), "no node, or no web-ifc below ILOT_NPM")
class Ifc(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name)
        must("scan", "facade-haussmann", "-o", cls.folder / "f.laz", "--points", 250000, "-q")
        cls.out = cls.folder / "out"
        stations = cls.folder / "f.stations.csv"
        must("run", cls.folder / "f.laz", "-o", cls.out, "--products", "facades", "--no-clouds", "-q",
             *(["--stations", stations] if stations.exists() else []), codes=(0, 3))
        must("export", cls.out, "--to", "ifc", "-o", cls.folder / "made")

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_sizes(self):
        """Sizes are those of the facade's JSON and of its DXF; what web-ifc cuts out of the wall are its openings."""
        plans = sorted((self.out / "facades").glob("facade-*.json"))
        self.assertTrue(plans)
        openings_met = sizes_met = 0
        for plan in plans:
            facade = json.loads(plan.read_text())
            read = seen_in_ifc(self.folder / "made" / (plan.stem + ".ifc"))
            self.assertEqual(read["schema"], "IFC4X3_ADD2")
            by_kind = lambda kind: {e["properties"]["ilot_Proof"]["Element"]: e for e in read["elements"] if e["type"] == kind}
            wall, = by_kind("IfcWall").values()
            openings, fillings = by_kind("IfcOpeningElement"), by_kind("IfcWindow") | by_kind("IfcDoor")
            drawn = schedule_of(plan.with_suffix(".dxf"))
            right, up = facade["frame"]["right"], facade["frame"]["up"]
            cut = 0
            for element in facade["elements"]:
                if not element["opening"] or element["status"] == "occluded":
                    self.assertNotIn(element["id"], openings)
                    continue
                out, origin = facade["frame"]["out"], facade["frame"]["origin"]
                stands_off = sum(readers.dot(readers.minus(p, origin), out) for p in element["ring"]) / len(element["ring"])
                if element["id"] not in openings:  # in the front of a dormer: a window, but no hole in the wall
                    self.assertGreater(abs(stands_off), 0.1)
                    self.assertAlmostEqual(fillings[element["id"]]["width"], element["width_m"], delta=2e-6)
                    continue
                openings_met += 1
                opening = openings[element["id"]]
                told = opening["properties"]["ilot_Dimensions"]
                for name, key in (("Width", "width_m"), ("Height", "height_m"), ("Depth", "depth_m"), ("WidthError", "width_error_m"),
                                  ("HeightError", "height_error_m")):
                    self.assertAlmostEqual(told[name], element[key], delta=2e-6)
                self.assertEqual(opening["properties"]["ilot_Proof"]["Points"], element["points"])
                if element["kind"] in ("window", "door"):
                    filling = fillings[element["id"]]
                    self.assertEqual(filling["type"], "Ifc" + element["kind"].capitalize())
                    self.assertAlmostEqual(filling["width"], element["width_m"], delta=2e-6)
                    self.assertAlmostEqual(filling["height"], element["height_m"], delta=2e-6)
                    self.assertIn([opening["id"], filling["id"]], read["fills"])
                if element["id"] in drawn:
                    sizes_met += 1
                    self.assertAlmostEqual(told["Width"], drawn[element["id"]][0], delta=6e-4)
                    self.assertAlmostEqual(told["Height"], drawn[element["id"]][1], delta=6e-4)
                self.assertIn([wall["id"], opening["id"]], read["voids"])
                tall = opening["mesh"]["high"][2] - opening["mesh"]["low"][2]
                self.assertAlmostEqual(tall, max(p[2] for p in element["ring"]) - min(p[2] for p in element["ring"]),
                                       delta=0.01 if element["arcs"] else 0.001)  # corners of an arc lie up to 5 mm beside it
                cut += ring_area(element["ring"], right, up)
            outline = next(e for e in facade["elements"] if e["kind"] == "outline")
            thick = wall["properties"]["ilot_Wall"]["Thickness"]
            self.assertIn("not measured", wall["properties"]["ilot_Wall"]["ThicknessIs"])
            whole = ring_area(outline["ring"], right, up)
            self.assertAlmostEqual(wall["mesh"]["volume"] / ((whole - cut) * thick), 1, delta=0.005)
            self.assertEqual(read["crs"], facade["crs"])
            corners = [[c + o for c, o in zip(p, read["map"])] for p in (wall["mesh"]["low"], wall["mesh"]["high"])]
            for axis in range(3):  # the wall where the scan has it, but for its thickness
                self.assertLess(abs(corners[0][axis] - min(p[axis] for p in outline["ring"])), thick + 0.01)
                self.assertLess(abs(corners[1][axis] - max(p[axis] for p in outline["ring"])), thick + 0.01)
            guids = [e["guid"] for e in read["elements"]]
            self.assertEqual(len(set(guids)), len(guids))
        self.assertGreater(openings_met, 10)
        self.assertGreater(sizes_met, 10, "the schedules of the DXF were read")


if __name__ == "__main__":
    unittest.main()
