#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Python package `ilot` from outside. ILOT_EXE names the program with which it is compared."""
import doctest
import importlib.util
import inspect
import json
import os
import pathlib
import signal
import sqlite3
import subprocess
import sys
import threading
import unittest

import numpy as np

import ilot
from scanned_case import EXE, ScannedCase


class Package(ScannedCase):
    POINTS = 60000

    def test_runs_are_those_of_the_program(self):
        subprocess.run([EXE, "run", self.cloud, "-o", self.folder / "program", "-q", "--products", "planes,roofs", "--set",
                        "roofs.detail=0.1"], check=True)
        stages = []
        result = ilot.run(self.cloud, self.folder / "python", products=["planes", "roofs"], settings={"roofs.detail": 0.1},
                          memory="512M", progress=lambda stage, *rest: stages.append(stage))
        self.assertEqual(result.result_hash, json.loads((self.folder / "program/run.json").read_text())["result_hash"])
        self.assertEqual(result, ilot.read_run(self.folder / "python"))
        self.assertEqual(result.exit, 0)
        self.assertEqual(result.points_read, len(self.points["x"]))
        self.assertIn("roofs", stages)
        again = ilot.roofs([self.cloud], self.folder / "again", detail=0.1, report=False)  # a second run in this process
        self.assertEqual(again.products, ["roofs"])
        self.check_planes(ilot.read_planes(self.folder / "python"))
        self.check_roofs(ilot.read_roofs(self.folder / "again"))
        self.refused("exists already", ilot.run, self.cloud, self.folder / "python")

    def check_planes(self, planes):
        self.assertEqual([p.id for p in planes], list(range(1, len(planes) + 1)))
        largest = max(planes, key=lambda p: p.area_m2)
        self.assertAlmostEqual(float(np.dot(largest.normal, largest.centroid)) + largest.d, 0, 3)
        self.assertEqual(largest.__geo_interface__["geometry"]["type"], "MultiPolygon")
        self.assertEqual(largest.__geo_interface__["properties"]["points"], largest.points)

    def check_roofs(self, buildings):
        whole = [b for b in buildings if b.attributes["status"] == "lod22"]
        self.assertGreater(len(whole), 0)
        vertices, surfaces = whole[0].levels["2.2"]
        self.assertEqual(vertices.shape[1], 3)
        self.assertEqual({s.kind for s in surfaces}, {"roof", "wall", "ground"})
        self.assertTrue(all(i < len(vertices) for s in surfaces for ring in s.rings for i in ring))
        roof = whole[0].__geo_interface__
        self.assertEqual(len(roof["geometry"]["coordinates"]), sum(s.kind == "roof" for s in surfaces))
        ring = roof["geometry"]["coordinates"][0][0]
        self.assertEqual(ring[0], ring[-1])

    def test_facades_and_streets_are_read_back(self):
        front, street = self.folder / "front.laz", self.folder / "street.laz"
        subprocess.run([EXE, "scan", "facade-restoration", "-o", front, "--points", "60000", "-q"], check=True)
        subprocess.run([EXE, "scan", "street", "-o", street, "--points", "500000", "-q", "--set", "scene.blocks=2"], check=True)
        ilot.facades(front, self.folder / "front", stations=front.with_suffix(".stations.csv"), report=False)
        facade = ilot.read_facades(self.folder / "front")[0]
        windows = [e for e in facade.elements if e.kind == "window"]
        self.assertGreater(len(windows), 5)
        self.assertEqual(windows[0].ring.shape[1], 3)
        self.assertEqual(len(windows[0].edge_error_m), len(windows[0].edge_status))
        ilot.streets(street, self.folder / "street", report=False)
        plan = ilot.read_streets(self.folder / "street")
        self.trees_and_kerbs(plan, self.folder / "street" / "streets")
        found = plan.objects
        self.assertGreater(len(found), 0)
        self.assertTrue({o.label for o in found} <= {"car", "van", "two_wheeler", "pedestrian", "lamppost", "sign", "bollard",
                                                    "bin", "bench", "planter", "fence", "cabinet", "other"})
        corners = np.array(found[0].__geo_interface__["geometry"]["coordinates"][0])
        self.assertAlmostEqual(float(np.hypot(*(corners[1] - corners[0]))), found[0].length_m, 6)

    def trees_and_kerbs(self, plan, folder):
        """As sqlite3 reads the layers; each list has the geometry that its type says."""
        def rows(layer, columns, file=None):
            with sqlite3.connect(folder / f"{file or layer}.gpkg") as table:
                return table.execute(f"select {columns} from {layer}").fetchall()
        trees = sorted(rows("trees", "tree_id, height_m, crown_radius_m, points"))
        kerbs = sorted(rows("kerbs", "kerb_id, height_m, length_m"))
        self.assertGreater(min(len(trees), len(kerbs), len(plan.blocks)), 0)
        for tree, row in zip(plan.trees, trees, strict=True):
            np.testing.assert_allclose((tree.id, tree.height_m, tree.crown_radius_m, tree.points), row, rtol=1e-6)
            self.assertEqual(tree.__geo_interface__["geometry"], {"type": "Point", "coordinates": tree.position[:2]})
        for kerb, row in zip(plan.kerbs, kerbs, strict=True):
            np.testing.assert_allclose((kerb.id, kerb.height_m, kerb.length_m), row, rtol=1e-6)
            self.assertEqual(kerb.line.shape, (len(kerb.heights_m), 3))
            self.assertAlmostEqual(np.hypot(*np.diff(kerb.line[:, :2], axis=0).T).sum(), kerb.length_m, 2)
            self.assertEqual(len(kerb.__geo_interface__["geometry"]["coordinates"]), len(kerb.line))
        widths = rows("widths", "width_m, passable_m, ends_at", "pavements")
        self.assertGreater(min(len(widths), len(plan.pavements)), 0)
        self.assertEqual([(None if w.ends_at == "open" else w.width_m, w.passable_m, w.ends_at) for w in plan.widths],
                         widths)
        areas = sum(abs(np.sum(r[:, 0] * np.roll(r[:, 1], -1) - r[:, 1] * np.roll(r[:, 0], -1))) / 2
                    for r in (p.ring - p.ring[0] for p in plan.pavements))
        self.assertAlmostEqual(areas, sum(p.area_m2 for p in plan.pavements), 0)
        self.assertEqual(plan.pavements[0].__geo_interface__["geometry"]["type"], "Polygon")
        roads = rows("carriageways", "carriageway_id, area_m2, width_m, narrowest_m, seen_share", "pavements")
        self.assertEqual([(c.id, c.area_m2, c.width_m, c.narrowest_m, c.seen_share) for c in plan.carriageways], roads)
        for road in plan.carriageways:
            self.assertEqual(len(road.__geo_interface__["geometry"]["coordinates"]), 1 + len(road.holes))
        for part in plan.blocks + plan.gaps:
            self.assertAlmostEqual(np.hypot(part.end[0] - part.start[0], part.end[1] - part.start[1]), part.length_m, 2)

    def test_clouds_go_out_and_come_in(self):
        for name in ("a.laz", "b.las", "c.ply"):
            ilot.write_cloud(self.folder / name, *self.places, intensity=self.points["intensity"],
                             classification=self.points["classification"], crs="EPSG:2154")
            back = ilot.read_cloud(self.folder / name)
            for column in ("x", "y", "z"):
                self.assertLess(np.abs(back[column] - self.points[column]).max(), 0.00051)
            self.assertTrue((back["classification"] == self.points["classification"]).all())
        info = ilot.info(self.folder / "a.laz")
        self.assertEqual((info["valid_points"], info["crs"]), (len(self.places[0]), "EPSG:2154"))
        self.assertTrue(info["suits"]["roofs"][0])
        self.assertEqual(len(ilot.read_cloud(self.cloud, first=100, most=10)["x"]), 10)
        self.refused("No such file", ilot.read_cloud, self.folder / "none.laz", code=1)

    def test_functions_over_points(self):
        x, y, z = self.places
        index, distance = ilot.nearest_neighbours(x, y, z, 4)
        self.assertEqual(index.shape, (len(x), 4))
        self.assertAlmostEqual(float(distance[7, 3]), float(np.linalg.norm([c[7] - c[index[7, 3]] for c in (x, y, z)])), 3)
        normals = np.stack(ilot.estimate_normals(x, y, z)[:3])
        length = np.linalg.norm(normals, axis=0)
        self.assertTrue(((np.abs(length - 1) < 1e-3) | (length == 0)).all())
        self.assertTrue((normals[2] >= 0).all())
        found = ilot.find_planes(x, y, z, epsilon=0.1)
        on = found["label"] > 0
        planes = found["planes"][found["label"][on] - 1]
        self.assertLessEqual(np.abs((planes[:, :3] * np.stack([x, y, z], 1)[on]).sum(1) + planes[:, 3]).max(), 0.1 + 1e-6)
        one = ilot.find_planes(x, y, z, epsilon=0.1, threads=1)
        self.assertTrue((one["label"] == found["label"]).all(), "no result depends on the threads")
        triangles = ilot.delaunay(x, y)
        a, b, c = (np.stack([x, y], 1)[triangles[:, k]] for k in range(3))
        self.assertTrue(((b - a)[:, 0] * (c - a)[:, 1] > (b - a)[:, 1] * (c - a)[:, 0]).all(), "they turn left")
        polygons, area = ilot.alpha_shape(x, y, 2.0)
        self.assertGreater(area, 0)
        self.assertGreater(len(polygons[0][0]), 3)
        identity, count = ilot.euclidean_clusters(x, y, z, 1.0)
        self.assertEqual(int(identity.max()) + 1, count)

    def test_wrong_words_are_refused(self):
        self.refused("planes.epsilon", ilot.run, self.cloud, self.folder / "w", settings={"planes.epsilom": 1})
        self.refused("512M", ilot.run, self.cloud, self.folder / "w", memory="lots")
        self.refused("overwrite", ilot.run, self.cloud, self.folder / "w", existing="yes")
        for bounds in ((1, 2, 3), (1, 2, 3, float("nan"))):
            self.refused("four finite numbers", ilot.run, self.cloud, self.folder / "w", bounds=bounds)
        self.refused("number of bytes", ilot.run, self.cloud, self.folder / "w", memory=-1)
        with self.assertRaisesRegex(TypeError, "progress"):
            ilot.run(self.cloud, self.folder / "w", progress=3)
        with self.assertRaisesRegex(TypeError, "did you mean detail"):
            ilot.roofs(self.cloud, self.folder / "w", detial=1)
        self.assertFalse((self.folder / "w").exists())

    def test_values_of_numpy_are_settings(self):
        options = {"report": False, "existing": "overwrite", "clouds": False}
        given = {"planes.epsilon": np.float64(0.1), "planes.curved": np.bool_(False), "classes.noise": np.array([7, 18]),
                 "planes.min_points": None, "classes.building": (6,)}
        one = ilot.run(self.cloud, self.folder / "numpy", settings=given, memory=np.int64(2**30), threads=np.int32(1), **options)
        two = ilot.run(self.cloud, self.folder / "numpy", settings={"planes.epsilon": 0.1, "planes.curved": False}, **options)
        self.assertEqual(one.result_hash, two.result_hash)

    def test_a_fork_works_after_a_run(self):
        script = ("import ilot, multiprocessing, sys\n"
                  "def make(folder): return ilot.run(sys.argv[1], folder, report=False).result_hash\n"
                  "one = make(sys.argv[2] + '/parent')\n"
                  "with multiprocessing.get_context('fork').Pool(2) as pool:\n"
                  "    print({one, *pool.map(make, [sys.argv[2] + '/a', sys.argv[2] + '/b'])} == {one})\n")
        room = self.folder / "forks"
        room.mkdir()
        done = subprocess.run([sys.executable, "-c", script, self.cloud, room], capture_output=True, text=True, timeout=300)
        self.assertEqual(done.stdout.strip(), "True", done.stderr)

    def test_clouds_in_memory_are_as_good_as_files(self):
        attributes = {name: self.points[name] for name in ("intensity", "classification") if name in self.points}
        file = self.folder / "same.laz"
        ilot.write_cloud(file, *self.places, **attributes, crs="EPSG:2154")
        cloud = ilot.Cloud(*self.places, **attributes, crs="EPSG:2154", name="same")
        of_file = ilot.run(file, self.folder / "of_file", products=["planes", "roofs"], report=False)
        in_memory = ilot.run(cloud, self.folder / "in_memory", products=["planes", "roofs"], report=False)
        files = [f for f in of_file.files if f not in of_file.clouds]
        self.assertGreater(len(files), 3)
        self.assertEqual(files, [f for f in in_memory.files if f not in in_memory.clouds])
        for name in files:
            self.assertEqual((of_file.folder / name).read_bytes(), (in_memory.folder / name).read_bytes(), name)
        self.assertEqual([str(c) for c in in_memory.clouds], ["points/same.npy"])
        labels = ilot.read_labels(in_memory.folder)["same"]
        self.assertIsInstance(labels, np.memmap)
        self.assertEqual(len(labels), len(cloud.x))
        stored = ilot.read_cloud(of_file.folder / of_file.clouds[0], extra=labels.dtype.names)
        for name in labels.dtype.names:
            self.assertTrue((labels[name] == stored[name]).all(), name)
        self.assertGreater((labels["plane_id"] > 0).mean(), 0.5)
        half = ilot.run([cloud, file], self.folder / "both", report=False)
        self.assertEqual((half.points_read, len(half.clouds)), (2 * len(cloud.x), 2))

    def test_clouds_in_memory_that_are_refused(self):
        x, y, z = self.places
        there = self.folder / "refused"
        bad = x.copy()
        bad[17] = np.nan
        for cloud, words in ((ilot.Cloud(bad, y, z), "x[17] = nan is not finite"), (ilot.Cloud(x, y, z[:-1].copy()), "different lengths"),
                             (ilot.Cloud(x.astype("f4"), y, z), "float32"), (ilot.Cloud(x, y, z, scale=0), "scale"),
                             (ilot.Cloud(x, y, z, name="a/b"), "no name"), (ilot.Cloud(x * 1e6, y, z), "2^31"),
                             (ilot.Cloud(x, y, z, crs="EPSG:1"), "EPSG:1"), (ilot.Cloud(*[np.array([])] * 3), "no points")):
            self.refused(words, ilot.run, cloud, there)
        twice = [ilot.Cloud(x, y, z, name="same"), ilot.Cloud(x, y, z, name="same")]
        self.refused('two clouds in memory are called "same"', ilot.run, twice, there)
        self.assertFalse(there.exists())

    def test_labels_are_called_as_their_cloud(self):
        clouds = [ilot.Cloud(*self.places, name="650.6860"), ilot.Cloud(*self.places, name="650.6870")]
        result = ilot.run(clouds, self.folder / "dots", report=False)
        self.assertEqual(sorted(str(c) for c in result.clouds), ["points/650.6860.npy", "points/650.6870.npy"])
        self.assertEqual(sorted(ilot.read_labels(result.folder)), ["650.6860", "650.6870"])

    def test_a_cloud_that_changed_is_not_resumed(self):
        def stop(stage, *_):
            if stage == "planes":
                raise ValueError("enough")
        x, y, z = self.places
        there = self.folder / "changed"
        with self.assertRaises(ValueError):
            ilot.run(ilot.Cloud(x, y, z), there, progress=stop)
        higher = z.copy()
        higher[5] += 1
        self.refused("changed", ilot.run, ilot.Cloud(x, y, higher), there, existing="resume")
        self.assertEqual(ilot.run(ilot.Cloud(x, y, z), there, existing="resume", report=False).exit, 0)

    def test_what_a_callback_raises_stops_the_run(self):
        def raise_it(*_):
            raise ValueError("enough")
        with self.assertRaisesRegex(ValueError, "enough"):
            ilot.run(self.cloud, self.folder / "stopped", progress=raise_it)
        self.assertFalse((self.folder / "stopped/run.json").exists())
        self.assertEqual(ilot.run(self.cloud, self.folder / "stopped", existing="resume").exit, 0)

    def test_a_stop_ends_one_run_and_not_that_which_waits(self):
        results, begun = [], threading.Event()

        def second():
            begun.set()
            results.append(ilot.run(self.cloud, self.folder / "waits", report=False))
        other = threading.Thread(target=second)

        def stop_when_the_other_waits(*_):
            other.start()
            begun.wait()
            raise ValueError("enough")
        with self.assertRaisesRegex(ValueError, "enough"):
            ilot.run(self.cloud, self.folder / "first", progress=stop_when_the_other_waits)
        other.join()
        self.assertEqual(results[0].exit, 0)

    def test_ctrl_c_ends_the_run_of_the_main_thread_alone(self):
        """The main thread waits for the run of another thread when Ctrl-C comes: it waits no longer, and that run goes on."""
        script = ("import ilot, os, signal, sys, threading\n"
                  "works, may_end, results = threading.Event(), threading.Event(), []\n"
                  "def hold(stage, *rest):\n"
                  "    works.set()\n"
                  "    may_end.wait()\n"
                  "other = threading.Thread(target=lambda: results.append(ilot.run(sys.argv[1], sys.argv[2] + '/other', progress=hold)))\n"
                  "other.start()\n"
                  "works.wait()\n"
                  "while True:\n"
                  "    threading.Timer(0.5, os.kill, [os.getpid(), signal.SIGINT]).start()\n"
                  "    try:\n"
                  "        ilot.run(sys.argv[1], sys.argv[2] + '/main')\n"
                  "    except KeyboardInterrupt as fault:\n"
                  "        if str(fault):  # not Python's own, where Ctrl-C came too early\n"
                  "            print(fault)\n"
                  "            break\n"
                  "may_end.set()\n"
                  "other.join()\n"
                  "print(results[0].exit)\n")
        done = subprocess.run([sys.executable, "-c", script, self.cloud, self.folder], capture_output=True, text=True, timeout=300)
        self.assertIn("waited for another run", done.stdout, done.stderr)
        self.assertEqual(done.stdout.splitlines()[-1], "0", done.stderr)
        self.assertFalse((self.folder / "main").exists())

    def test_other_threads_work_meanwhile(self):
        results = []
        work = threading.Thread(target=lambda: results.append(ilot.run(self.cloud, self.folder / "beside", report=False)))
        work.start()
        turns = 0
        while work.is_alive():
            turns += 1
        self.assertEqual(results[0].exit, 0)
        self.assertGreater(turns, 100, "the interpreter's lock is released")

    def test_ctrl_c_can_be_resumed(self):
        script = ("import ilot, os, signal, sys\n"
                  "def kill(stage, *rest):\n"
                  "    if stage == 'planes': os.kill(os.getpid(), signal.SIGINT)\n"
                  "try:\n"
                  "    ilot.run(sys.argv[1], sys.argv[2], progress=kill)\n"
                  "except KeyboardInterrupt:\n"
                  "    print(ilot.run(sys.argv[1], sys.argv[2], existing='resume').result_hash)\n")
        done = subprocess.run([sys.executable, "-c", script, self.cloud, self.folder / "killed"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.strip(), ilot.run(self.cloud, self.folder / "whole").result_hash)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler, "the handler is Python's again")

    def test_the_examples_of_the_page_run(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        page = (root / "docs/python.md").read_text() + (root / "README.md").read_text()
        folder = self.folder / "page"
        folder.mkdir()
        (folder / "town.laz").write_bytes(self.cloud.read_bytes())
        examples = [part.split("```")[0] for part in page.split("```python\n")[1:]]
        self.assertGreater(len(examples), 3)
        for example in examples:
            if "geopandas" in example and importlib.util.find_spec("geopandas") is None:
                print("SKIPPED: an example needs python3-geopandas", file=sys.stderr)
                continue
            done = subprocess.run([sys.executable, "-c", example], cwd=folder, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, example + done.stderr)

    def test_importing_is_quick(self):
        """NumPy takes longer to load than the rest, and a run needs none of it."""
        script = "import ilot, sys; ilot.parameters(); print('numpy' in sys.modules)"
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), "False")

    def test_everything_public_is_documented(self):
        for name in ilot.__all__:
            self.assertTrue(inspect.getdoc(getattr(ilot, name)), name)
        os.chdir(self.folder)
        self.assertEqual(doctest.testmod(sys.modules["ilot.clouds"]).failed, 0)


if __name__ == "__main__":
    unittest.main()
