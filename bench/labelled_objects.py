#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the objects of `ilot run --products streets` with those that a person sees (bench/labels). Needs ILOT_DATA.

An object of the run finds a label when its middle is in the rectangle of the label, grown by 0.3 m; of several the one whose
extent is nearest to the label's counts. The class is right where both names mean the same (see MEANS). An object that is in no
label of any kind is false. Labels that are `part` or `doubtful` count neither as lost nor as false. Walls and ground are compared
by points: the share of the points in the box that have that label.

usage: bench/labelled_objects.py [ILOT] [--labels NAME] [--set KEY=VALUE ...] [--list]
"""
import argparse
import collections
import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import parked_cars

ROOT = pathlib.Path(__file__).resolve().parent.parent
GROWN = 0.3  # metres
CLOUDS = {
    "amsterdam_sidewalk": (["amsterdam/run2_sidewalk_2386_9702.laz"], "EPSG:28992"),
    "ign_trees": (["ign/" + f for f in parked_cars.CLOUDS.values()], "EPSG:2154"),
    "small_source": (["small/source.ply"], None),
}
VALUES = {"ground": {1}, "wall": {3, 5}}  # of the field label: wall and facade
# What the classes of a run may be called for a label. A class that the product does not have is "other".
MEANS = {
    "two-wheeler": {"two_wheeler", "bicycle", "motorcycle", "other"}, "two-wheelers": {"two_wheeler", "rack", "other"},
    "bench": {"bench", "other"}, "table": {"other", "bench"}, "furniture": {"other", "bench"},
    "tree": {"tree", "vegetation"}, "hedge": {"hedge", "vegetation", "fence", "wall"},
    "lamppost": {"lamppost", "pole"}, "post": {"pole", "lamppost", "bollard", "sign", "other"}, "bin": {"bin", "other"},
}


def arguments():
    parser = argparse.ArgumentParser(prog="bench/labelled_objects.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--labels", action="append", choices=CLOUDS, help="only these [all]")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="a setting of the run")
    parser.add_argument("--list", action="store_true", help="every label and every object in no label")
    return parser.parse_args()


def labels_of(name):
    with open(ROOT / "bench/labels" / f"{name}.csv") as file:
        return [{k: v if k in ("class", "seen") else float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def inside(label, x, y, grown=GROWN):
    a = math.radians(label["heading_deg"])
    dx, dy = x - label["x"], y - label["y"]
    along, across = dx * math.cos(a) + dy * math.sin(a), dy * math.cos(a) - dx * math.sin(a)
    return abs(along) <= label["length_m"] / 2 + grown and abs(across) <= label["width_m"] / 2 + grown


def nearest_extent(label, objects):
    """Returns the object whose length and width are nearest to the label's."""
    return min(objects, default=None, key=lambda o: abs(math.log(max(o["length_m"], 0.05) / label["length_m"])) +
               abs(math.log(max(o["width_m"], 0.05) / label["width_m"])))


def compare_objects(labels, objects, listed):
    counts = collections.defaultdict(collections.Counter)
    for label in labels:
        found = nearest_extent(label, [o for o in objects if inside(label, o["x"], o["y"])])
        if listed:
            print(f"  {label['class']} {label['seen']} {label['x']:.1f} {label['y']:.1f}: "
                  f"{parked_cars.describe(found) if found else 'no object'}")
        if label["seen"] != "whole":
            continue
        of = counts[label["class"]]
        of["all"] += 1
        of["found"] += found is not None
        of["right"] += found is not None and found["class"] in MEANS.get(label["class"], {label["class"]})
    nowhere = [o for o in objects if not any(inside(l, o["x"], o["y"]) for l in labels)]
    for o in nowhere if listed else []:
        print(f"  in no label: {parked_cars.describe(o)}")
    for kind, of in sorted(counts.items()):
        print(f"  {kind}: {of['found']} of {of['all']} found, {of['right']} of the right class")
    called = collections.Counter(o["class"] for o in nowhere)
    print(f"  {len(objects)} objects, in no label: {', '.join(f'{n} {c}' for c, n in sorted(called.items())) or 'none'}")


def labelled_points(cloud, args):
    """Returns x, y, z and label of every point, as text that `ilot convert` writes."""
    with tempfile.TemporaryDirectory() as folder:
        text = pathlib.Path(folder) / "points.csv"
        subprocess.run([args.ilot, "convert", "-q", str(cloud), str(text)], check=True)
        with open(text) as file:
            for row in csv.DictReader(file):
                yield float(row["x"]), float(row["y"]), float(row["z"]), int(float(row["label"]))


def compare_points(labels, run, args):
    clouds = sorted((run / "points").glob("*.la[sz]"))
    counts = [collections.Counter() for _ in labels]
    for cloud in clouds:
        for x, y, z, value in labelled_points(cloud, args):
            for label, count in zip(labels, counts):
                if label["low_m"] <= z <= label["high_m"] and inside(label, x, y, 0):
                    count["all"] += 1
                    count["right"] += value in VALUES[label["class"]]
    for label, count in zip(labels, counts):
        share = 100 * count["right"] / count["all"] if count["all"] else math.nan
        print(f"  {label['class']} at {label['x']:.1f} {label['y']:.1f}: {share:.0f} % of {count['all']} points")


def study(args, name, folder):
    clouds, crs = CLOUDS[name]
    data = pathlib.Path(os.environ["ILOT_DATA"])
    command = [args.ilot, "run", *(str(data / c) for c in clouds), "-o", str(folder), "--products", "streets", "--threads", "1"]
    command += ["--crs", crs] if crs else []
    done = subprocess.run(command + [w for s in args.set for w in ("--set", s)], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(done.stderr)
    labels = labels_of(name)
    print(f"{name}:")
    if "low_m" in labels[0]:
        compare_points(labels, folder, args)
    else:
        compare_objects(labels, parked_cars.objects_of(folder), args.list)


def main():
    args = arguments()
    if "ILOT_DATA" not in os.environ:
        sys.exit("ILOT_DATA is not set: nothing to look at")
    with tempfile.TemporaryDirectory() as folder:
        for name in args.labels or CLOUDS:
            study(args, name, pathlib.Path(folder) / name)


if __name__ == "__main__":
    main()
