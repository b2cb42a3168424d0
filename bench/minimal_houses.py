#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the protrusions and recesses that are found on fourteen small buildings whose colours are the labels
(MinimalHouse). Colours are removed, `ilot run --products facades` runs, and its result is compared with the labels.
Needs ILOT_DATA.

Each building is used three times: as it is; with 5 mm of noise; and with this noise and only the points that one of
four stations sees. There is one station before each side, to the left of it. The program does not know the stations.

A labelled part is a piece of the reference mesh. An element is right when it stands out of its facade (label
protrusion) or goes into it (recess) and half of its points belong to the part. A part is found when right elements
together contain half of its points. Four pairs of these buildings are one shape with two labels: an upper storey that
stands out, or a lower one that stands back. So besides `as labelled` there is `either way`: an element of the other
sign also counts where its points include the face between the two storeys (a twentieth of them).

usage: bench/minimal_houses.py [ILOT] [--only NUMBER ...] [--variants plain noise scan] [--keep FOLDER] [--list]
"""
import argparse
import csv
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

from facade_frame import in_axes

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLOURS = {"protrusion": lambda r, g, b: g > r and g > b, "recess": lambda r, g, b: b < r and b < g and r > 0 and g > 0}
MATERIALS = {"Convex": "protrusion", "Concave": "recess"}
NOISE, WITHIN, SHARE, SHARED_FACE, RIGHT = 0.005, 0.03, 0.5, 0.05, 0.01  # metres, metres, shares, metres
JUDGED = 4  # one in this number of points is evaluated, because Python is slow


def arguments():
    parser = argparse.ArgumentParser(prog="bench/minimal_houses.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--only", nargs="*", type=int, default=list(range(14)))
    parser.add_argument("--variants", nargs="*", default=["plain", "noise", "scan"])
    parser.add_argument("--keep", metavar="FOLDER", help="leave clouds and results there")
    parser.add_argument("--list", action="store_true", help="every labelled part and every element")
    return parser.parse_args()


def call(command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(f"{' '.join(str(c) for c in command)}\n{done.stderr}")


def labelled_points(ilot, cloud, folder):
    """Returns [(position, label or None)]."""
    text = folder / "labelled.csv"
    call([ilot, "convert", cloud, text, "--overwrite"])
    points = []
    with open(text) as file:
        for row in csv.DictReader(file):
            colour = [int(float(row[c])) for c in ("red", "green", "blue")]
            label = next((name for name, is_it in COLOURS.items() if is_it(*colour)), None)
            points.append((tuple(float(row[c]) for c in "xyz"), label))
    return points


def labelled_parts(mesh):
    """Returns the pieces of the mesh of one material, joined over corners: [(label, low, high)]."""
    corners, faces, material = [], [], None
    for line in open(mesh):
        words = line.split()
        if words[:1] == ["v"]:
            corners.append(tuple(float(w) for w in words[1:4]))
        elif words[:1] == ["usemtl"]:
            material = MATERIALS.get(words[1].split(".")[0])
        elif words[:1] == ["f"] and material:
            faces.append((material, [int(w.split("/")[0]) - 1 for w in words[1:]]))
    parent = {}

    def find(key):
        while parent.setdefault(key, key) != key:
            key = parent[key]
        return key
    for material, face in faces:
        for corner in face[1:]:
            parent[find((material, corner))] = find((material, face[0]))
    pieces = {}
    for material, face in faces:
        pieces.setdefault(find((material, face[0])), []).extend(corners[i] for i in face)
    return [(key[0], [min(p[k] for p in piece) for k in range(3)], [max(p[k] for p in piece) for k in range(3)])
            for key, piece in sorted(pieces.items())]


def noisy(points, seed):
    draw = random.Random(seed)
    return [(tuple(c + draw.gauss(0, NOISE) for c in p), label) for p, label in points]


def seen(points):
    """Returns the points that one of four stations sees, by a depth image of each."""
    low = [min(p[k] for p, _ in points) for k in range(3)]
    high = [max(p[k] for p, _ in points) for k in range(3)]
    middle, half = [(a + b) / 2 for a, b in zip(low, high)], [(b - a) / 2 for a, b in zip(low, high)]
    cell, behind, away, left, up = math.radians(0.3), 0.3, 9, 6, 1.6
    kept = [False] * len(points)
    for out in ((0, -1), (1, 0), (0, 1), (-1, 0)):
        reach = abs(out[0]) * half[0] + abs(out[1]) * half[1] + away
        eye = (middle[0] + reach * out[0] + left * out[1], middle[1] + reach * out[1] - left * out[0], low[2] + up)
        image, places = {}, []
        for p, _ in points:
            d = [a - b for a, b in zip(p, eye)]
            flat = math.hypot(d[0], d[1])
            pixel = (math.floor(math.atan2(d[1], d[0]) / cell), math.floor(math.atan2(d[2], flat) / cell))
            far = math.hypot(flat, d[2])
            places.append((pixel, far))
            if far < image.get(pixel, math.inf):
                image[pixel] = far
        for i, (pixel, far) in enumerate(places):
            kept[i] = kept[i] or far <= image[pixel] + behind
    return [p for p, keep in zip(points, kept) if keep]


def run(ilot, points, folder):
    cloud = folder / "cloud.xyz"
    with open(cloud, "w") as file:
        file.writelines(f"{p[0]:.5f} {p[1]:.5f} {p[2]:.5f}\n" for p, _ in points)
    call([ilot, "run", cloud, "-o", folder / "out", "--overwrite", "--products", "facades", "-q"])
    return [json.loads(f.read_text()) for f in sorted((folder / "out/facades").glob("facade-*.json"))]


def found_elements(facades, points):
    """Returns the elements that stand out of a facade or go into it, with the points on them."""
    found = []
    for facade in facades:
        local = [in_axes(facade["frame"], p) for p, _ in points]
        for e in facade["elements"]:
            if e["kind"] in ("outline", "stone", "joint") or abs(e["depth_m"]) < WITHIN or e["status"] == "occluded":
                continue
            places = e["ring"] + (e.get("body") or {}).get("vertices", [])
            box = [in_axes(facade["frame"], p) for p in places]
            low, high = ([f(p[k] for p in box) - s * WITHIN for k in range(2)] for f, s in ((min, 1), (max, -1)))
            sign = 1 if e["depth_m"] > 0 else -1
            held = {i for i, p in enumerate(local)
                    if low[0] <= p[0] <= high[0] and low[1] <= p[1] <= high[1] and
                    WITHIN < sign * p[2] <= abs(e["depth_m"]) + WITHIN}
            found.append({"facade": facade, "element": e, "sign": sign, "points": held,
                          "label": "protrusion" if sign > 0 else "recess"})
    return found


def points_of_parts(parts, points):
    held = [set() for _ in parts]
    for i, (p, label) in enumerate(points):
        for k, (name, low, high) in enumerate(parts):
            if name == label and all(a - WITHIN <= c <= b + WITHIN for a, c, b in zip(low, p, high)):
                held[k].add(i)
                break
    return held


def true_size(frame, part, sign):
    """Returns width, height, and the distance before the facade (or behind it). A part may continue around a corner."""
    size = [b - a for a, b in zip(part[1], part[2])]
    corners = [in_axes(frame, [part[1 + (i >> k & 1)][k] for k in range(3)]) for i in range(8)]
    return [sum(abs(frame[axis][k]) * size[k] for k in range(3)) for axis in ("right", "up")] + \
        [max(sign * c[2] for c in corners)]


def evaluate(parts, points, found):
    """Returns for each part and each element 2 (as labelled), 1 (either way) or 0 (not found or wrong), and the errors
    of sizes in metres."""
    held = points_of_parts(parts, points)
    of_part, of_found, errors = [0] * len(parts), [0] * len(found), []
    for k, part in enumerate(parts):
        union = set()
        for i, f in enumerate(found):
            common, own = len(held[k] & f["points"]), max(1, len(f["points"]))
            direct = f["label"] == part[0] and common >= SHARE * own
            other = f["label"] != part[0] and common >= SHARED_FACE * own
            if direct:
                union |= held[k] & f["points"]
            if direct and common >= SHARE * len(held[k]):
                e, size = f["element"], true_size(f["facade"]["frame"], part, f["sign"])
                errors += [abs(a - b) for a, b in zip((e["width_m"], e["height_m"], abs(e["depth_m"])), size)]
            of_part[k] = max(of_part[k], 1 if other else 0)
            of_found[i] = max(of_found[i], 2 if direct else 1 if other else 0)
        if held[k] and len(union) >= SHARE * len(held[k]):
            of_part[k] = 2
    return of_part, of_found, errors


def show(number, parts, found, of_part, of_found):
    for part, how in zip(parts, of_part):
        print(f"  {number} label {part[0]:10} {[round(a, 2) for a in part[1]]} to {[round(a, 2) for a in part[2]]}: {how}")
    for f, how in zip(found, of_found):
        e = f["element"]
        print(f"  {number} found facade {f['facade']['facade']} {e['kind']:10} {e['width_m']:.3f} x {e['height_m']:.3f} x "
              f"{e['depth_m']:.3f} at {[round(c, 2) for c in e['ring'][0]]}, {len(f['points'])} points: {how}")


def measure(options, variant, data, folder):
    parts_found, found_right, all_errors = [], [], []
    for number in options.only:
        cloud = data / f"minimal_house_{number}.laz"
        points = labelled_points(options.ilot, cloud, folder)
        points = points if variant == "plain" else noisy(points, number)
        points = seen(points) if variant == "scan" else points
        place = pathlib.Path(options.keep) / f"{variant}-{number}" if options.keep else folder
        place.mkdir(parents=True, exist_ok=True)
        parts = labelled_parts(data / f"references/minimal_house_{number}.obj")
        facades, judged = run(options.ilot, points, place), points[::JUDGED]
        found = found_elements(facades, judged)
        of_part, of_found, errors = evaluate(parts, judged, found)
        if options.list:
            show(number, parts, found, of_part, of_found)
        parts_found += of_part
        found_right += of_found
        all_errors += errors
    count = lambda values, least: sum(v >= least for v in values)
    near = sum(e <= RIGHT for e in all_errors)
    sizes = f"{near} of {len(all_errors)}, largest {max(all_errors, default=0):.3f} m"
    print(f"| {variant} | {len(parts_found)} | {count(parts_found, 2)} | {count(parts_found, 1)} | {len(found_right)} | "
          f"{count(found_right, 2)} | {count(found_right, 1)} | {sizes} |", flush=True)


def main():
    options = arguments()
    if "ILOT_DATA" not in os.environ:
        sys.exit("bench/minimal_houses.py: ILOT_DATA names no folder of clouds: nothing to measure")
    print("| variant | labelled parts | found as labelled | either way | elements found | right as labelled | either way | "
          "sizes within 1 cm |")
    print("|---|---|---|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as work:
        for variant in options.variants:
            measure(options, variant, pathlib.Path(os.environ["ILOT_DATA"]) / "minimalhouse", pathlib.Path(work))


if __name__ == "__main__":
    main()
