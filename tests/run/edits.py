#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Corrections by hand survive the next run: run, correct, run again; the correction stands and all else is the same."""
import contextlib
import csv
import io
import json
import pathlib
import shutil
import sqlite3
import struct
import tempfile

from support import RunTest, ilot, main


def files_of(out):
    return {p.relative_to(out): p.read_bytes() for p in sorted(out.rglob("*")) if p.is_file() and p.name != "run.json"}


class EditsTest(RunTest):
    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()
        del cls.kept, cls.base

    def once(self, make):
        """What all tests of a class read: made by the first of them, in a folder that they share."""
        cls = type(self)
        if not hasattr(cls, "base"):
            own, cls.kept = self.folder, tempfile.TemporaryDirectory(prefix="ilot-edits-")
            self.folder = pathlib.Path(cls.kept.name)
            cls.base = make()
            self.folder = own
        return cls.base

    def table(self, name, *rows):
        columns = sorted({key for row in rows for key in row})
        text = io.StringIO()
        writer = csv.DictWriter(text, columns)
        writer.writeheader()
        writer.writerows(rows)
        path = self.folder / name
        path.write_text(text.getvalue())
        return path


class Facades(EditsTest):
    def setUp(self):
        super().setUp()
        self.cloud, self.asked, self.out = self.once(self.base_run)
        self.plan = json.loads((self.out / "facades/facade-001.json").read_text())
        self.windows = [e for e in self.plan["elements"] if e["kind"] == "window" and len(e["ring"]) == 4]

    def base_run(self):
        path, asked = self.facade(150000)
        return path, asked, self.work(path, *asked)[0]

    def row(self, edit, element, along=0.0, up=0.0, **more):
        """An edit of an element; with along and up, the place to which it is moved, in metres."""
        low, high = element["ring"][0], element["ring"][2]
        row = {"product": "facades", "edit": edit, "kind": element["kind"], **more}
        row.update({f"{axis}{n}": corner[k] for n, corner in ((1, low), (2, high)) for k, axis in enumerate("xyz")})
        if edit == "moved":
            right = self.plan["frame"]["right"]
            for n, corner in ((1, low), (2, high)):
                for k, axis in enumerate("xyz"):
                    row[f"to_{axis}{n}"] = corner[k] + along * right[k] + (up if axis == "z" else 0)
        return row

    def place(self, element, plan=None):
        frame = (plan or self.plan)["frame"]
        return sorted((sum((p[k] - self.plan["frame"]["origin"][k]) * frame["right"][k] for k in range(3)), p[2])
                      for p in element["ring"])

    def same_but_for(self, plan, changed):
        """Asserts that all elements but these of both plans are the same, but for their ids and for what is counted around
        them: the points of the wall are others when its openings are."""
        counted = ("id", "points", "rms_m", "covered_share", "occluded_share", "faces")

        def drawn(value):
            if isinstance(value, dict):
                return {k: drawn(v) for k, v in value.items() if k not in counted}
            return [drawn(v) for v in value] if isinstance(value, list) else value

        def others(elements, left_out):
            return [drawn(e) for e in elements if e["id"] not in left_out]
        before, after = changed
        self.assertEqual(others(self.plan["elements"], before), others(plan["elements"], after))

    def test_corrections_stand_and_all_else_is_the_same(self):
        first, second, third = self.windows[:3]
        edits = self.table("edits.csv", self.row("moved", first, along=0.25), self.row("deleted", second),
                           self.row("kind", third, to_kind="door"))
        out, run = self.work(self.cloud, *self.asked, "--edits", edits)
        self.assertEqual(run["edits"], {"given": 3, "made": 3, "repeated": 0, "without_partner": 0, "outside": 0,
                                        "not_asked": 0})
        plan = json.loads((out / "facades/facade-001.json").read_text())
        hand = [e for e in plan["elements"] if e["status"] == "by hand"]
        self.assertEqual([e["reason"].split(";")[0] for e in hand], ["moved by hand", "kind set by hand"])
        moved, door = hand
        for (u0, v0), (u1, v1) in zip(self.place(first), self.place(moved, plan)):
            self.assertAlmostEqual(u0 + 0.25, u1, 6)
            self.assertAlmostEqual(v0, v1, 6)
        self.assertEqual(door["kind"], "door")
        self.assertEqual(self.place(third), self.place(door))
        self.assertEqual([e["error_m"] is None for e in moved["edges"]], [False, True, False, True])
        self.assertIsNone(moved["width_error_m"])
        self.same_but_for(plan, ([first["id"], second["id"], third["id"]], [moved["id"], door["id"]]))
        rows = list(csv.DictReader((out / "facades/facade-001.csv").open()))
        by_hand = [r for r in rows if r["status"] == "by hand"]
        self.assertEqual([r["edge_error_m"] == "by hand" for r in by_hand], [True, False])
        dxf = (out / "facades/facade-001.dxf").read_text()
        self.assertEqual(dxf.count("\nby hand\n"), 3)  # STATUS of both, ERROR of one
        self.assertEqual(ilot("export", out, "--to", "ifc", "-o", out.parent / "ifc").returncode, 0)
        ifc = (out.parent / "ifc/facade-001.ifc").read_text()
        self.assertEqual(ifc.count("IFCLABEL('by hand')"), 4)  # of two openings and what fills them
        self.assertNotRegex(ifc, r"'WidthError',\$,IFCLENGTHMEASURE\(0\.0*\)", "no error is stated by hand")
        again, _ = self.work(self.cloud, *self.asked, "--edits", edits, "--threads", "1", "--memory", "256M")
        self.assertEqual(files_of(again), files_of(out))

    def test_no_edits_change_nothing(self):
        empty = self.table("empty.csv", {"product": "", "edit": ""})
        out, run = self.work(self.cloud, *self.asked, "--edits", empty)
        self.assertEqual(files_of(out), files_of(self.out))
        self.assertEqual(run["edits"]["given"], 0)

    def test_from_a_corrected_drawing(self):
        ours = self.out / "facades/facade-001.dxf"
        text = ours.read_text()
        theirs = self.folder / "theirs.dxf"
        tags = text.split("\n")
        at = next(i for i in range(0, len(tags) - 1, 2) if tags[i].strip() == "0" and tags[i + 1] == "INSERT")
        x = next(i for i in range(at + 2, len(tags), 2) if tags[i].strip() == "10")
        tags[x + 1] = repr(float(tags[x + 1]) + 0.1)
        theirs.write_text("\n".join(tags))
        table = self.folder / "from.csv"
        done = ilot("edits", "--from-drawing", ours, theirs, "-o", table)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 moved;", done.stdout)
        out, run = self.work(self.cloud, *self.asked, "--edits", table)
        self.assertEqual(run["edits"]["made"], 1)
        check = ilot("evaluate", "--drawing", out / "facades/facade-001.dxf", "--corrected", theirs, "--json")
        layers = {layer["layer"]: layer for layer in json.loads(check.stdout)["drawing"]}
        self.assertEqual((layers["all"]["moved"], layers["all"]["removed"]), (0, 0), "the run draws what was corrected")

    def test_what_finds_no_partner_is_told(self):
        window = self.windows[0]
        far = self.row("deleted", window)
        for n in (1, 2):
            far[f"z{n}"] += 500
        edits = self.table("edits.csv", far, self.row("moved", window, along=0.1))
        out, run = self.work(self.cloud, *self.asked, "--edits", edits, code=3)
        self.assertEqual((run["edits"]["made"], run["edits"]["without_partner"]), (1, 1))
        self.assertEqual([(s["what"], s["where"]) for s in run["skipped"]], [("edit", f"{edits}:2")])
        _, other = self.work(self.cloud, "--products", "planes", "--edits", edits)
        self.assertEqual(other["edits"]["not_asked"], 2)
        self.assertTrue(any("2 edits not used" in w for w in other["warnings"]))

    def test_contradictions_and_faults_end_before_anything_is_made(self):
        window = self.windows[0]
        a = self.table("a.csv", self.row("moved", window, along=0.1))
        b = self.table("b.csv", self.row("deleted", window))
        out = self.folder / "refused"
        done = ilot("run", self.cloud, "-o", out, *self.asked, "--edits", a, "--edits", b, "-q")
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"{b}:2: contradicts {a}:2", done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertFalse(out.exists())

    def test_resume_notices_changed_edits(self):
        edits = self.table("edits.csv", self.row("moved", self.windows[0], along=0.1))
        out, _ = self.work(self.cloud, *self.asked, "--edits", edits)
        self.work(self.cloud, *self.asked, "--edits", edits, "--resume", out=out)
        shutil.copy(self.table("other.csv", self.row("moved", self.windows[0], along=0.2)), edits)
        done = ilot("run", self.cloud, "-o", out, *self.asked, "--edits", edits, "--resume", "-q")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("edits", done.stderr)


class Roofs(EditsTest):
    def setUp(self):
        super().setUp()
        self.cloud, out = self.once(self.base_run)
        self.buildings = self.buildings_of(out)

    def base_run(self):
        cloud = self.district(60000)
        return cloud, self.work(cloud, "--products", "roofs")[0]

    @staticmethod
    def buildings_of(out):
        """The attributes of each building, and its LoD2.2 as rings of places by face."""
        lines = [json.loads(line) for line in (out / "roofs/roofs.city.jsonl").read_text().splitlines()]
        scale, shift = lines[0]["transform"]["scale"], lines[0]["transform"]["translate"]
        buildings = {}
        for feature in lines[1:]:
            places = [[p * s + t for p, s, t in zip(v, scale, shift)] for v in feature["vertices"]]
            faces, solid = {}, None
            for part in feature["CityObjects"].values():
                for geometry in part.get("geometry", []):
                    if geometry["lod"] == "2.2":
                        solid = geometry
            if solid is not None:
                semantics = solid["semantics"]
                for surface, kind in zip(solid["boundaries"][0], semantics["values"][0]):
                    face = semantics["surfaces"][kind]
                    if face["type"] == "RoofSurface":
                        faces.setdefault(face["plane_id"], []).append([places[i] for i in surface[0]])
            attributes = feature["CityObjects"][feature["id"]]["attributes"]
            buildings[feature["id"]] = {"attributes": attributes, "faces": list(faces.values()), "places": places}
        return buildings

    @staticmethod
    def middle(face):
        ring = face[0]
        return [sum(p[k] for p in ring) / len(ring) for k in range(3)]

    def gable(self):
        """The id of a building of two faces of four corners, and a place on each face."""
        for name, building in self.buildings.items():
            faces = building["faces"]
            if len(faces) == 2 and all(len(f) == 1 and len(f[0]) == 4 for f in faces):
                return name, [self.middle(f) for f in faces]
        self.fail("the district has no gable")

    def merge(self, a, b):
        return {"product": "roofs", "edit": "merged", "x1": a[0], "y1": a[1], "x2": b[0], "y2": b[1]}

    def area(self, name, by=0.6):
        """A rectangle around a building, as WKT."""
        places = self.buildings[name]["places"]
        x0, x1 = min(p[0] for p in places) - by, max(p[0] for p in places) + by
        y0, y1 = min(p[1] for p in places) - by, max(p[1] for p in places) + by
        return f"POLYGON (({x0} {y0}, {x1} {y0}, {x1} {y1}, {x0} {y1}, {x0} {y0}))"

    def same_but_for(self, buildings, changed):
        for name, building in self.buildings.items():
            if name in changed:
                continue
            before, after = ({k: v for k, v in b["attributes"].items() if k != "unit_id"} for b in (building, buildings[name]))
            self.assertEqual(before, after)
            self.assertEqual(building["places"], buildings[name]["places"])

    def test_faces_are_merged_and_all_else_is_the_same(self):
        name, (a, b) = self.gable()
        edits = self.table("edits.csv", self.merge(a, b), self.merge(b, a))
        out, run = self.work(self.cloud, "--products", "roofs", "--edits", edits)
        self.assertEqual(run["edits"], {"given": 2, "made": 1, "repeated": 1, "without_partner": 0, "outside": 0,
                                        "not_asked": 0})
        buildings = self.buildings_of(out)
        self.assertEqual(len(buildings[name]["faces"]), 1)
        self.assertEqual(buildings[name]["attributes"]["by_hand"], "1 merge of faces")
        self.assertEqual(buildings.keys(), self.buildings.keys())
        self.same_but_for(buildings, [name])
        again, _ = self.work(self.cloud, "--products", "roofs", "--edits", edits, "--threads", "1", "--memory", "128M")
        self.assertEqual(files_of(again), files_of(out))
        self.assertEqual(ilot("validate", out / "roofs/roofs.city.jsonl").returncode, 0)

    def test_classes_take_a_building_out_and_give_another_class_back(self):
        name, _ = self.gable()
        other = {"product": "roofs", "edit": "kind", "to_kind": "other", "WKT": self.area(name)}
        out, run = self.work(self.cloud, "--products", "roofs", "--edits", self.table("other.csv", other))
        self.assertEqual(run["edits"]["made"], 1)
        buildings = self.buildings_of(out)
        self.assertNotIn(name, buildings)
        self.same_but_for(buildings, [name])
        # A later line gives the points above the floor their class again.
        floor = self.buildings[name]["attributes"]["h_ground"] + 0.5
        back = {**other, "to_kind": "building", "z1": floor}
        both = self.table("both.csv", other, back)
        out, run = self.work(self.cloud, "--products", "roofs", "--edits", both)
        self.assertEqual(run["edits"]["made"], 2)
        buildings = self.buildings_of(out)
        self.assertEqual(len(buildings[name]["faces"]), 2)
        self.assertIn("classes of", buildings[name]["attributes"]["by_hand"])

    def test_what_finds_no_partner_is_told(self):
        name, (a, b) = self.gable()
        far = [a[0] + 5000, a[1], a[2]]
        nothing = {"product": "roofs", "edit": "kind", "to_kind": "ground",
                   "area": "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"}
        edits = self.table("edits.csv", self.merge(a, far), nothing, self.merge(a, b))
        _, run = self.work(self.cloud, "--products", "roofs", "--edits", edits, code=3)
        self.assertEqual((run["edits"]["made"], run["edits"]["without_partner"]), (1, 2))
        self.assertEqual(sorted(s["where"] for s in run["skipped"]), [f"{edits}:2", f"{edits}:3"])

    def test_contradictions_end_before_anything_is_made(self):
        name, _ = self.gable()
        row = {"product": "roofs", "edit": "kind", "area": self.area(name)}
        edits = self.table("edits.csv", {**row, "to_kind": "ground"}, {**row, "to_kind": "other"})
        out = self.folder / "refused"
        done = ilot("run", self.cloud, "-o", out, "--products", "roofs", "--edits", edits, "-q")
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"{edits}:3: contradicts {edits}:2", done.stderr)
        self.assertFalse(out.exists())


class Streets(EditsTest):
    def setUp(self):
        super().setUp()
        self.cloud, self.asked, out = self.once(self.base_run)
        self.objects = self.objects_of(out)

    def base_run(self):
        cloud, asked = self.street(400000)
        return cloud, asked, self.work(cloud, *asked)[0]

    @staticmethod
    def objects_of(out):
        """Class, probability, by hand, points and place of the objects."""
        with contextlib.closing(sqlite3.connect(out / "streets/objects.gpkg")) as file:
            rows = file.execute("SELECT class, probability, by_hand, points, geom FROM objects ORDER BY object_id").fetchall()
        objects = []
        for name, probability, by_hand, points, shape in rows:
            envelope = (0, 32, 48, 48, 64)[shape[3] >> 1 & 7]
            x, y = struct.unpack("<dd", shape[8 + envelope + 5:8 + envelope + 21])
            objects.append({"class": name, "probability": probability, "by_hand": by_hand, "points": points, "x": x, "y": y})
        return objects

    def first(self, name):
        return next(o for o in self.objects if o["class"] == name)

    @staticmethod
    def row(edit, *objects, **more):
        row = {"product": "streets", "edit": edit, **more}
        for n, o in enumerate(objects, 1):
            row[f"x{n}"], row[f"y{n}"] = o["x"], o["y"]
        return row

    def test_corrections_stand_and_can_be_learnt(self):
        car, lamp, person = self.first("car"), self.first("lamppost"), self.first("pedestrian")
        edits = self.table("edits.csv", self.row("kind", car, to_kind="van"), self.row("deleted", lamp),
                           self.row("merged", car, person), self.row("deleted", {"x": car["x"] + 900, "y": car["y"]}))
        out, run = self.work(self.cloud, *self.asked, "--edits", edits, code=3)
        self.assertEqual((run["edits"]["made"], run["edits"]["without_partner"]), (3, 1))
        objects = self.objects_of(out)
        hand = [o for o in objects if o["by_hand"]]
        self.assertEqual([(o["class"], o["probability"], o["points"]) for o in hand],
                         [("van", None, car["points"] + person["points"])])
        self.assertEqual([o for o in objects if not o["by_hand"]],
                         [o for o in self.objects if o not in (car, lamp, person)])
        apart = self.table("apart.csv", self.row("merged", car, person), self.row("split", car, person))
        back, run = self.work(self.cloud, *self.asked, "--edits", apart)
        self.assertEqual(run["edits"]["made"], 2)
        self.assertEqual([(o["class"], o["x"], o["points"]) for o in self.objects_of(back) if o["by_hand"]],
                         [(o["class"], o["x"], o["points"]) for o in self.objects if o in (car, person)])
        places = self.folder / "places.csv"
        self.assertEqual(ilot("edits", "--training", edits, "-o", places).returncode, 0)
        self.assertEqual([line.split(",")[-1] for line in places.read_text().splitlines()], ["class", "van", "none", "none"])


class Storeys(RunTest):
    def test_facades_give_buildings_their_storeys(self):
        cloud = self.scan("building", 200000, self.folder / "building.laz", storeys=4)
        out, _ = self.work(cloud, "--products", "roofs,facades")
        buildings = [b["attributes"] for b in Roofs.buildings_of(out).values()]
        self.assertEqual(max(buildings, key=lambda b: b["points"])["storeys"], 4)


if __name__ == "__main__":
    main(synthetic=[Facades, Roofs, Streets, Storeys])
