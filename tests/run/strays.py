#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that isolated points far from all others change only the count of strays."""
import json
import struct

from support import Las, RunTest, ilot, main

KINDS = ("origin", "zeros", "behind", "200 km", "1,000 km", "below", "above")
FEW_KINDS = ("zeros", "1,000 km")  # for the slower products; the table of all is in tests/full


def raw_at(las, place):
    """Returns a coordinate as a writer stores it. A value that does not fit into 32 bits is clipped."""
    return [max(-2**31, min(2**31 - 1, round((v - o) / s))) for v, o, s in zip(place, las.offset, las.scale)]


def with_strays(las, kind):
    """Returns the records with strays, and the numbers of strays before and after the others."""
    x, y, z = las.points()[0]
    place = {"200 km": (x + 2e5, y + 2e5, z), "1,000 km": (x - 1e6, y + 1e6, z), "below": (x, y, z - 1200),
             "above": (x, y, z + 1200)}.get(kind, (0, 0, 0))
    rows = [struct.pack("<iii", *raw_at(las, place)) + las.records()[0][12:]] * (10000 if kind == "zeros" else 1)
    if kind == "behind":
        return las.records() + rows, 0, len(rows)
    return rows + las.records(), len(rows), 0


def write_ply(path, points):
    head = ("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
            "property double z\nend_header\n" % len(points))
    path.write_bytes(head.encode() + b"".join(struct.pack("<3d", *p) for p in points))


class Strays(RunTest):
    def products(self, out):
        """Returns every file of the products except the clouds, by name."""
        files = [path for path in out.rglob("*") if path.is_file() and "points" not in path.relative_to(out).parts]
        return {str(path.relative_to(out)): path.read_bytes() for path in files if path.name != "run.json"}

    def folder_of(self, name):
        folder = self.folder / name
        folder.mkdir()
        return folder

    def compare(self, scene, points, kinds, *arguments, code=0):
        clean_path = self.scan(scene, points)
        clean = Las.read(clean_path)
        out, run_json = self.work(clean_path, *arguments, code=code)
        wanted, rows = self.products(out), self.labelled(out, scene).records()
        self.assertEqual(run_json["counts"]["points"]["rejected"], 0)
        for kind in kinds:
            with self.subTest(scene=scene, kind=kind):
                records, before, behind = with_strays(clean, kind)
                path = clean.write(self.folder_of(f"{scene} {kind}") / clean_path.name, records)
                with_them, other_json = self.work(path, *arguments, "--memory", "128M", code=code)
                self.assertEqual(self.products(with_them), wanted)
                labelled = self.labelled(with_them, scene).records()
                self.assertEqual(labelled[before:len(labelled) - behind], rows)
                for row in labelled[:before] + labelled[len(labelled) - behind:]:
                    self.assertEqual(bytes(row[clean.length:]), bytes(len(row) - clean.length), "it has no label")
                counts = dict(other_json["counts"]["points"])
                self.assertEqual(counts.pop("rejected"), before + behind)
                self.assertEqual(counts.pop("read"), clean.count + before + behind)
                self.assertEqual(sum(counts.values()), clean.count)
                self.assertTrue(any("index.keep_strays" in text for text in other_json["warnings"]), other_json["warnings"])
                info = json.loads(ilot("info", path, "--json", "-q").stdout)[0]
                self.assertEqual(info["strays"]["points"], before + behind)

    def test_planes_and_roofs(self):
        self.compare("district", 40000, KINDS, "--products", "planes,roofs")

    def test_streets(self):
        self.compare("street", 120000, FEW_KINDS, "--products", "streets")

    def test_facades(self):
        self.compare("facade-restoration", 40000, FEW_KINDS, "--products", "facades")

    def test_info_measures_the_rest(self):
        path = self.scan("district", 40000)
        clean = Las.read(path)
        strays = clean.write(self.folder / "strays.las", with_strays(clean, "zeros")[0])
        a, b = (json.loads(ilot("info", p, "--json", "-q").stdout)[0] for p in (path, strays))
        for key in ("bounds", "area_m2", "density_per_m2", "sampling_step_m", "suits"):
            self.assertEqual(b[key], a[key], key)
        self.assertIn("10,000 points stand alone", ilot("info", strays, "-q").stdout)

    def test_a_setting_keeps_them(self):
        clean = Las.read(self.district(20000))
        path = clean.write(self.folder / "stray.las", with_strays(clean, "200 km")[0])
        _, run_json = self.work(path, "--set", "index.keep_strays=true", "--no-clouds")
        self.assertEqual(run_json["counts"]["points"]["rejected"], 0)

    def test_two_real_parts_both_stay(self):
        clean = Las.read(self.district(20000))
        east = [struct.pack("<i", x + 50000000) + r[4:] for (x, _, _), r in zip(clean.raw(), clean.records())]
        path = clean.write(self.folder / "two.las", clean.records() + east)
        _, one = self.work(self.folder / "district-20000.las", "--no-clouds")
        _, run_json = self.work(path, "--no-clouds")
        self.assertEqual(run_json["counts"]["points"]["rejected"], 0)
        self.assertGreaterEqual(run_json["counts"]["planes"], 2 * one["counts"]["planes"] - 4)

    def test_an_area_makes_no_point_a_stray(self):
        """Whether a point is isolated is decided with the points outside the area, too."""
        clean = Las.read(self.district(40000))
        x, y, _ = clean.points()[0]
        path = clean.write(self.folder / "stray.las", with_strays(clean, "above")[0])
        area = ("--bounds", f"{x - 3},{y - 3},{x + 3},{y + 3}", "--no-clouds")
        a, _ = self.work(self.folder / "district-40000.las", *area)
        b, run_json = self.work(path, *area)
        self.assertEqual(self.products(b), self.products(a))
        self.assertEqual(run_json["counts"]["points"]["rejected"] > 0, True)

    def test_a_first_point_decides_no_scale(self):
        clean = Las.read(self.district(20000))
        points = clean.points()
        outs = []
        for name, strays in (("clean", []), ("far", [(1e9, 1e9, 1e9)]), ("zeros", [(0, 0, 0)] * 3000)):
            path = self.folder_of(name) / "cloud.ply"
            write_ply(path, strays + points)
            out, run_json = self.work(path, "--crs", "EPSG:2154", "--products", "planes,roofs", code=3)
            self.assertEqual(run_json["counts"]["points"]["rejected"], len(strays))
            outs.append(self.products(out))
        self.assertEqual(outs[1], outs[0])
        self.assertEqual(outs[2], outs[0])

    def test_a_scale_finer_than_the_coordinates(self):
        """Integer millimetres in steps of 0.01 mm give the same store and the same products."""
        path = self.district(40000)
        clean = Las.read(path)
        fine = [struct.pack("<iii", *(100 * v for v in raw)) + r[12:] for raw, r in zip(clean.raw(), clean.records())]
        steps = tuple(s / 100 for s in clean.scale)
        other = clean.write(self.folder_of("fine") / path.name, fine, scale=steps)
        products = ("--products", "planes,roofs")
        a, plain = self.work(path, *products)
        b, run_json = self.work(other, *products)
        self.assertEqual(self.products(b), self.products(a))
        self.assertEqual(run_json["blocks"], plain["blocks"])
        tail = clean.length
        self.assertEqual([r[tail:] for r in self.labelled(b, path.stem).records()],
                         [r[tail:] for r in self.labelled(a, path.stem).records()])

    def test_points_all_over_the_world_are_refused(self):
        clean = Las.read(self.district(20000))
        seed, records = 1, []
        for record in clean.records() * 2:
            place = []
            for _ in range(3):
                seed = seed * 6364136223846793005 + 1442695040888963407 & 2**64 - 1
                place.append((seed >> 32) - 2**31)
            records.append(struct.pack("<iii", *place) + record[12:])
        path = clean.write(self.folder / "wide.las", records, scale=(1, 1, 1))
        done = ilot("run", path, "-o", self.folder / "out", "-q")
        self.assertEqual(done.returncode, 1)
        self.assertIn("spread too far", done.stderr)
        self.assertFalse((self.folder / "out" / "run.json").exists())


if __name__ == "__main__":
    main(synthetic=[Strays])
