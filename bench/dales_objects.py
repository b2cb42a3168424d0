#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `ilot run --products streets` calls 200 real objects that were cut out of a flight (DALES: cars, fences, poles, trees). Needs ILOT_DATA.

The objects have no ground. They are laid on a level plane 20 m apart, with points of the ground at random places; once with points
below all of them, as where a car moved between two flight lines, and once with none below what is lower than 3 m, as a pulse sees it.
The view is set to air. An object counts by the first object of the run whose middle is in its box, grown by half a metre, and
as a tree where a tree is there and no object. They are for judging: no model is trained on them.

usage: bench/dales_objects.py [ILOT] [--density POINTS]
"""
import argparse
import collections
import gzip
import os
import pathlib
import sqlite3
import struct
import subprocess
import sys
import tempfile

import numpy as np
import parked_cars

ROOT = pathlib.Path(__file__).resolve().parent.parent
APART = 20  # metres
COLUMNS = 15  # objects of a row
GROUND = 50.0  # metres, its height
NOISE = 0.03  # metres, of the ground
GROWN = 0.5  # metres
LOW = 3.0  # metres; what is lower hides the ground below it
MEANS = {"car": "car", "fence": "fence", "pole": "lamppost", "tree": "tree"}


def arguments():
    parser = argparse.ArgumentParser(prog="bench/dales_objects.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--density", type=float, default=20, help="points of the ground per square metre [20]")
    return parser.parse_args()


def objects_on_plane():
    """Returns the kind and the points of each object at its place."""
    out = []
    for i, path in enumerate(sorted((pathlib.Path(os.environ["ILOT_DATA"]) / "streets/dales_objects").glob("*.gz"))):
        points = np.loadtxt(gzip.open(path))[:, :3]
        low, high = points.min(axis=0), points.max(axis=0)
        middle = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
        place = np.array([APART * (i % COLUMNS + 0.5), APART * (i // COLUMNS + 0.5), GROUND])
        out.append((path.name.split("_")[0], points - middle + place))
    return out


def ground_of(objects, density, below):
    rows = (len(objects) + COLUMNS - 1) // COLUMNS
    count = int(APART * COLUMNS * APART * rows * density)
    random = np.random.default_rng(1)
    ground = np.column_stack([random.uniform(0, APART * COLUMNS, count), random.uniform(0, APART * rows, count),
                              GROUND + random.normal(0, NOISE, count)])
    free = np.ones(count, bool)
    for _, points in objects if not below else []:
        low, high = points.min(axis=0), points.max(axis=0)
        if high[2] - low[2] < LOW:
            free &= ~np.all((ground[:, :2] > low[:2]) & (ground[:, :2] < high[:2]), axis=1)
    return ground[free]


def write_las(path, points):
    """LAS 1.2, point format 0, millimetres."""
    whole = np.round(points / 0.001).astype("<i4")
    low, high = whole.min(axis=0) * 0.001, whole.max(axis=0) * 0.001
    header = bytearray(227)
    header[0:4], header[24], header[25] = b"LASF", 1, 2
    struct.pack_into("<HIIBHI5I", header, 94, 227, 227, 0, 0, 20, len(points), len(points), 0, 0, 0, 0)
    struct.pack_into("<6d", header, 131, 0.001, 0.001, 0.001, 0, 0, 0)
    struct.pack_into("<6d", header, 179, high[0], low[0], high[1], low[1], high[2], low[2])
    records = np.zeros(len(points), dtype=[("place", "<i4", 3), ("rest", "u1", 8)])
    records["place"] = whole
    records["rest"][:, 2] = 9  # one return of one
    path.write_bytes(bytes(header) + records.tobytes())


def trees_of(run):
    """Returns the places of the trees."""
    with sqlite3.connect(run / "streets/trees.gpkg") as base:
        return [struct.unpack_from("<2d", row[0], parked_cars.start_of(row[0]) + 5) for row in base.execute("select geom from trees")]


def called(points, objects, trees):
    low, high = points.min(axis=0) - GROWN, points.max(axis=0) + GROWN
    inside = lambda x, y: low[0] <= x <= high[0] and low[1] <= y <= high[1]
    names = [o["class"] for o in objects if inside(o["x"], o["y"])]
    if names:
        return names[0]
    return "tree" if any(inside(x, y) for x, y in trees) else "nothing"


def main():
    args = arguments()
    if "ILOT_DATA" not in os.environ:
        print("SKIPPED: ILOT_DATA is not set")
        return
    objects = objects_on_plane()
    with tempfile.TemporaryDirectory() as folder:
        for below in (True, False):
            cloud, run = pathlib.Path(folder) / "plane.las", pathlib.Path(folder) / "run"
            write_las(cloud, np.vstack([p for _, p in objects] + [ground_of(objects, args.density, below)]))
            done = subprocess.run([args.ilot, "run", cloud, "-o", run, "--products", "streets", "--overwrite", "--no-report",
                                   "--set", "streets.view=air"], capture_output=True, text=True)
            if done.returncode not in (0, 3):
                sys.exit(done.stderr)
            counts = collections.defaultdict(collections.Counter)
            found, trees = parked_cars.objects_of(run), trees_of(run)
            for kind, points in objects:
                counts[kind][called(points, found, trees)] += 1
            print(f"ground {'below all' if below else 'not below what is low'}, {args.density:g} points per square metre:")
            for kind, names in counts.items():
                others = ", ".join(f"{n} {name}" for name, n in names.most_common() if name != MEANS[kind])
                print(f"  {kind}: {names[MEANS[kind]]} of {sum(names.values())} called {MEANS[kind]}; {others}")


if __name__ == "__main__":
    main()
