#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the parked cars that `ilot run --products streets` finds from the air with those that a person sees (`ign`,
three tiles of 50 m). Needs ILOT_DATA.

parked_cars.csv contains what was seen in pictures of the points of the tiles, coloured by height and by class, before
any model was trained on clouds from the air. There are cars marked `whole` and cars marked `part`. A `part` is cut by
the end of the cloud, seen by only one flight line, or perhaps another object; it counts neither as lost nor, where it
is classified as car, as false. A car is found when an object classified as car has its middle in the rectangle of the
car, grown by half a metre. Each object counts for one car. An object is false if it is classified as car and is not in
the list.

usage: bench/parked_cars.py [ILOT] [--alone] [--set KEY=VALUE ...] [--list]
"""
import argparse
import csv
import json
import math
import os
import pathlib
import sqlite3
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CLOUDS = {"77050": "77050_627755_pf8.laz", "77055": "77055_627755_pf8.laz", "77060": "77060_627755_pf3.laz"}
GROWN = 0.5  # metres


def arguments():
    parser = argparse.ArgumentParser(prog="bench/parked_cars.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--alone", action="store_true", help="each tile by itself, not the three together")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="a setting of the run")
    parser.add_argument("--list", action="store_true", help="every car and every object")
    return parser.parse_args()


def seen_cars():
    with open(ROOT / "bench/parked_cars.csv") as file:
        return [{k: v if k in ("tile", "seen") else float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def start_of(geometry):
    """Returns where the geometry begins behind its header in a GeoPackage."""
    return 8 + {0: 0, 1: 32, 2: 48, 3: 48, 4: 64}[geometry[3] >> 1 & 7]


def middle_of(geometry):
    """Returns the middle of a rectangle in a GeoPackage."""
    at = start_of(geometry)
    kind, _, corners = struct.unpack_from("<3I", geometry, at + 1)
    size = 24 if kind > 1000 else 16
    places = [struct.unpack_from("<2d", geometry, at + 13 + size * i) for i in range(corners - 1)]
    return [sum(p[k] for p in places) / len(places) for k in (0, 1)]


def objects_of(run):
    """Returns the objects on the ground: x, y, class and so on."""
    with sqlite3.connect(run / "streets/objects.gpkg") as base:
        base.row_factory = sqlite3.Row
        rows = [dict(r) for r in base.execute("select o.*, e.geom as box from objects o join extents e using (object_id)")]
    for row in rows:
        row["x"], row["y"] = middle_of(row.pop("box"))
    return rows


def contains(car, detected):
    a = math.radians(car["heading_deg"])
    x, y = detected["x"] - car["x"], detected["y"] - car["y"]
    along, across = x * math.cos(a) + y * math.sin(a), y * math.cos(a) - x * math.sin(a)
    return abs(along) <= car["length_m"] / 2 + GROWN and abs(across) <= car["width_m"] / 2 + GROWN


def evaluate(cars, objects):
    """Returns the finds of each car, nearest first, and the objects classified as car that are not cars."""
    called = [o for o in objects if o["class"] == "car"]
    found, taken = [], set()
    for car in cars:
        near = sorted((math.hypot(o["x"] - car["x"], o["y"] - car["y"]), i) for i, o in enumerate(called)
                      if i not in taken and contains(car, o))
        found.append(called[near[0][1]] if near else None)
        taken.update(i for _, i in near[:1])
    on_part = {i for i, o in enumerate(called) if any(c["seen"] == "part" and contains(c, o) for c in cars)}
    return found, [o for i, o in enumerate(called) if i not in taken and i not in on_part]


def run_on(args, clouds, folder):
    settings = [word for s in args.set for word in ("--set", s)]
    command = [args.ilot, "run", *clouds, "--crs", "EPSG:2154", "-o", folder, "--products", "streets", "--threads", "1"]
    done = subprocess.run([str(c) for c in command] + settings, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(done.stderr)
    return json.loads((folder / "run.json").read_text())


def describe(o):
    return (f"{o['class']} {o['probability']:.2f} at {o['x']:.1f} {o['y']:.1f}, {o['length_m']:.1f} by {o['width_m']:.1f} m, "
            f"{o['height_m']:.1f} m high, {o['points']} points")


def study(args, name, tiles, folder):
    data = pathlib.Path(os.environ["ILOT_DATA"]) / "ign"
    run_on(args, [data / CLOUDS[t] for t in tiles], folder)
    cars = [c for c in seen_cars() if c["tile"] in tiles]
    objects = objects_of(folder)
    found, false = evaluate(cars, objects)
    whole = [f for c, f in zip(cars, found) if c["seen"] == "whole"]
    part = [f for c, f in zip(cars, found) if c["seen"] == "part"]
    print(f"{name}: {sum(f is not None for f in whole)} of {len(whole)} cars, "
          f"{sum(f is not None for f in part)} of {len(part)} seen in part; {len(false)} false; {len(objects)} objects")
    for tile in tiles if len(tiles) > 1 else []:
        here = [f for c, f in zip(cars, found) if c["seen"] == "whole" and c["tile"] == tile]
        print(f"  {tile}: {sum(f is not None for f in here)} of {len(here)}")
    if args.list:
        for car, find in zip(cars, found):
            print(f"  {car['seen']} {car['x']:.1f} {car['y']:.1f}: {describe(find) if find else 'lost'}")
        for o in false:
            print(f"  false: {describe(o)}")


def main():
    args = arguments()
    if "ILOT_DATA" not in os.environ:
        sys.exit("ILOT_DATA is not set: nothing to look at")
    groups = [[t] for t in CLOUDS] if args.alone else [list(CLOUDS)]
    with tempfile.TemporaryDirectory() as folder:
        for tiles in groups:
            study(args, " ".join(tiles), tiles, pathlib.Path(folder) / tiles[0])


if __name__ == "__main__":
    main()
