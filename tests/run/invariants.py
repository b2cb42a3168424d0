#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Invariants 3, 4, 6 and 7: epsilon, completeness, unchanged inputs, shifts, rotations and areas."""
import collections
import math
import pathlib
import struct

from support import Las, RunTest, ilot, main, planes_of, real

LATTICE_SHIFT = 1000 * 2**22  # units


class Invariants(RunTest):
    def check_run(self, path, run_json, out):
        """Tests that no labelled point is farther than epsilon, that no point is lost, and that the bytes of the input
        come back in their order."""
        before, after = Las.read(path), self.labelled(out, path.stem)
        planes = {p["plane_id"]: p for p in planes_of(out)}
        self.assertEqual(sorted(planes), list(range(1, len(planes) + 1)), "ids are dense from 1")
        self.assertEqual(len({p["content_id"] for p in planes.values()}), len(planes))
        self.assertEqual(before.count, after.count)
        self.assertTrue(all(a[:before.length] == b for a, b in zip(after.records(), before.records())),
                        "input records keep their order and bytes")
        carried = collections.Counter()
        for (x, y, z), (plane_id, residual, _) in zip(after.points(), after.labels()):
            carried[plane_id] += 1
            if plane_id == 0:
                self.assertEqual(residual, 0)
                continue
            p = planes[plane_id]
            distance = p["nx"] * x + p["ny"] * y + p["nz"] * z + p["d"]
            if abs(distance) > p["epsilon_m"] or abs(distance - residual) > 1e-6:
                self.fail(f"({x}, {y}, {z}) lies {distance} m from plane {plane_id} with epsilon {p['epsilon_m']}, "
                          f"residual {residual}")
        counts = run_json["counts"]["points"]
        self.assertEqual(counts["read"], before.count)
        self.assertEqual(counts["read"], counts["labelled"] + counts["unlabelled"] + counts["rejected"])
        self.assertEqual(counts["labelled"], before.count - carried[0])
        self.assertEqual({i: p["points"] for i, p in planes.items()}, {i: n for i, n in carried.items() if i})
        self.assertEqual(run_json["counts"]["planes"], len(planes))

    def check_shift(self, path):
        cloud = Las.read(path)
        offset = [o + LATTICE_SHIFT * s for o, s in zip(cloud.offset, cloud.scale)]
        moved = cloud.write(self.folder / "moved.las", offset=offset)
        here, _ = self.work(path)
        there, _ = self.work(moved)
        self.assertTrue(self.labelled(here, path.stem).labels() == self.labelled(there, "moved").labels())
        for a, b in zip(planes_of(here), planes_of(there), strict=True):
            for key in ("content_id", "points", "nx", "ny", "nz", "epsilon_m", "rms_m"):
                self.assertEqual(a[key], b[key], key)

    def rotated(self, cloud, path, degrees):
        """Rotates about the middle of the box. The rotation is exact for 90 degrees."""
        raw = cloud.raw()
        mx, my = (max(p[i] for p in raw) + min(p[i] for p in raw) >> 1 for i in (0, 1))
        cos, sin = (0, 1) if degrees == 90 else (math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))
        records = [struct.pack("<ii", round(cos * (x - mx) - sin * (y - my)) + mx,
                               round(sin * (x - mx) + cos * (y - my)) + my) + record[8:]
                   for record, (x, y, _) in zip(cloud.records(), raw)]
        return cloud.write(path, records)

    def check_rotations(self, path, planes_off, labelled_off):
        cloud = Las.read(path)
        counts = self.work(path)[1]["counts"]
        for degrees in (90, 37):
            turned = self.rotated(cloud, self.folder / f"turned-{degrees}.las", degrees)
            other = self.work(turned)[1]["counts"]
            self.assertLessEqual(abs(other["planes"] - counts["planes"]), planes_off * counts["planes"], (counts, other))
            share = (other["points"]["labelled"] - counts["points"]["labelled"]) / cloud.count
            self.assertLessEqual(abs(share), labelled_off, (counts, other))

    def check_bounds(self, path, share, margin):
        """Planes inside the middle part of the cloud are the same whether or not the rest is processed."""
        cloud = Las.read(path)
        whole, _ = self.work(path)
        every = planes_of(whole)
        low = [min(p[i] for p in cloud.points()) for i in (0, 1)]
        high = [max(p[i] for p in cloud.points()) for i in (0, 1)]
        middle, half = [(a + b) / 2 for a, b in zip(low, high)], [(b - a) * share / 2 for a, b in zip(low, high)]
        box = [middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1]]
        box = [(round(b / cloud.scale[0]) + 0.5) * cloud.scale[0] for b in box]  # no point is on its border
        out, run_json = self.work(path, "--bounds", ",".join(map(repr, box)))
        found = {p["content_id"]: p for p in planes_of(out)}
        inside = [p for p in every if p["min_x"] > box[0] + margin and p["max_x"] < box[2] - margin and
                  p["min_y"] > box[1] + margin and p["max_y"] < box[3] - margin]
        self.assertGreater(len(inside), 5)
        for p in inside:
            self.assertIn(p["content_id"], found, p)
            for key in ("points", "nx", "ny", "nz", "d", "epsilon_m", "rms_m"):
                self.assertEqual(p[key], found[p["content_id"]][key], key)
        return box, out, run_json


class Synthetic(Invariants):
    def test_run(self):
        path = self.district(200000)
        out, run_json = self.work(path)
        self.check_run(path, run_json, out)

    def test_offset_beside_the_lattice(self):
        cloud = Las.read(self.district(60000))
        for i, part in enumerate((0.25, 0.5, 0.999)):
            offset = [o + part * s for o, s in zip(cloud.offset, cloud.scale)]
            path = cloud.write(self.folder / f"beside-{i}.las", offset=offset)
            out, run_json = self.work(path)
            self.check_run(path, run_json, out)

    def test_files_of_different_lattices(self):
        cloud = Las.read(self.district(60000))
        records = cloud.records()
        offset = [o + 0.5 * s for o, s in zip(cloud.offset, cloud.scale)]
        paths = [cloud.write(self.folder / "even.las", records[0::2]),
                 cloud.write(self.folder / "odd.las", records[1::2], offset=offset)]
        out, run_json = self.work(paths)
        self.assertEqual(run_json["counts"]["points"]["read"], cloud.count)
        planes = {p["plane_id"]: p for p in planes_of(out)}
        for path in paths:
            labelled = self.labelled(out, path.stem)
            for (x, y, z), (plane_id, residual, _) in zip(labelled.points(), labelled.labels()):
                if plane_id:
                    p = planes[plane_id]
                    distance = p["nx"] * x + p["ny"] * y + p["nz"] * z + p["d"]
                    self.assertLessEqual(abs(distance), p["epsilon_m"], path.stem)
                    self.assertLessEqual(abs(distance - residual), 1e-6, path.stem)

    def test_scale_finer_than_the_lattice(self):
        cloud = Las.read(self.district(60000))
        low = [min(p[i] for p in cloud.raw()) for i in range(3)]
        records = [struct.pack("<iii", *(p - a for p, a in zip(raw, low))) + record[12:]
                   for record, raw in zip(cloud.records(), cloud.raw())]
        path = cloud.write(self.folder / "fine.las", records, scale=(1e-6, 1e-6, 1e-6), offset=(0, 0, 0))
        out, run_json = self.work(path)
        self.check_run(path, run_json, out)

    def test_shift(self):
        self.check_shift(self.district(200000))

    def test_rotations(self):
        self.check_rotations(self.district(200000), 0.05, 0.01)

    def test_bounds(self):
        self.check_bounds(self.district(500000), 0.4, 4)

    def test_bounds_label_nothing_outside(self):
        path = self.district(300000)
        box, out, run_json = self.check_bounds(path, 0.6, 4)
        outside = sum(1 for (x, y, _), (plane, *_) in zip(Las.read(path).points(), self.labelled(out, path.stem).labels())
                      if plane and not (box[0] - 1e-6 <= x <= box[2] + 1e-6 and box[1] - 1e-6 <= y <= box[3] + 1e-6))
        self.assertEqual(outside, 0, "labelled points outside the area")


class WithoutClouds(RunTest):
    def check(self, scene, points, product):
        path = self.folder / f"{scene}.las"
        self.assertEqual(ilot("scan", scene, "-o", path, "--points", points, "-q").returncode, 0)
        whole, run_json = self.work(path, "--products", product)
        out, bare = self.work(path, "--products", product, "--no-clouds")
        self.assertEqual(bare["counts"], run_json["counts"])
        files = [f.relative_to(whole) for f in whole.rglob("*") if f.is_file()]
        others = [f for f in files if f.parts[0] != "points" and f.name != "run.json"]
        self.assertEqual(len(others) + 2, len(files))
        self.assertEqual(sorted(f.relative_to(out) for f in out.rglob("*") if f.is_file()),
                         sorted([*others, pathlib.Path("run.json")]))
        for file in others:
            self.assertEqual((out / file).read_bytes(), (whole / file).read_bytes(), file)
        return path, out, run_json

    def test_all_else_is_the_same(self):
        self.check("roofs", 150000, "roofs")
        self.check("street", 150000, "streets")
        path, out, run_json = self.check("district", 20000, "planes")
        _, again = self.work(path, "--overwrite", out=out)
        self.assertEqual(again["result_hash"], run_json["result_hash"], "a run with clouds over one without")


class Real(Invariants):
    def test_urban_tile(self):
        path = real("ign/77050_627755_pf6.las")
        out, run_json = self.work(path)
        self.check_run(path, run_json, out)
        self.check_shift(path)

    def test_coloured_tile(self):
        path = real("ign/870000_6618000.las")
        out, run_json = self.work(path)
        self.check_run(path, run_json, out)
        self.check_rotations(path, 0.15, 0.03)

    def test_feet(self):
        path = real("autzen/autzen_north_buildings.las")
        cloud = Las.read(path)
        part = cloud.write(self.folder / "part.las", cloud.records()[:150000])
        out, run_json = self.work(part)
        self.assertGreater(run_json["counts"]["planes"], 20)


if __name__ == "__main__":
    main(synthetic=[Synthetic, WithoutClouds], real=[Real])
