#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the windows and doors of two real facades (NUIST), as `ilot run --products facades` draws them, with the
labelled ones. Needs ILOT_DATA.

The folder of a facade has a file of points for every labelled object. Together they are the cloud, without labels and
without a station. A labelled window or door is the rectangle that contains all but 0.2 % of its points on each side, in
the axes of a facade that was found. Each is paired with at most one drawn rectangle. The pair with the best
intersection over union is made first.

usage: bench/labelled_openings.py [ILOT] [--keep FOLDER] [--list] [--set KEY=VALUE ...]
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from facade_frame import in_axes, overlap

ROOT = pathlib.Path(__file__).resolve().parent.parent
TAIL, BESIDE, FOUND = 0.002, 2, 0.5  # share of points, metres, intersection over union
STEPS = [0.9, 0.8, 0.7, 0.6, 0.5]


def arguments():
    parser = argparse.ArgumentParser(prog="bench/labelled_openings.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--keep", metavar="FOLDER", help="leave clouds and results there")
    parser.add_argument("--list", action="store_true", help="every labelled thing")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="settings of the runs")
    return parser.parse_args()


def points_of(file):
    return [tuple(float(w) for w in line.split()[:3]) for line in open(file) if len(line.split()) >= 3]


def run(options, labelled, folder):
    cloud = folder / "cloud.xyz"
    with open(cloud, "w") as file:
        for _, points in labelled:
            file.writelines(f"{p[0]:.6f} {p[1]:.6f} {p[2]:.6f}\n" for p in points)
    settings = [word for s in options.set for word in ("--set", s)]
    done = subprocess.run([options.ilot, "run", cloud, "-o", folder / "out", "--overwrite", "--products", "facades", "-q",
                           *settings], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(done.stderr)
    return [json.loads(f.read_text()) for f in sorted((folder / "out/facades").glob("facade-*.json"))]


def quantile(values, share):
    return sorted(values)[int(share * (len(values) - 1))]


def box_of_points(frame, points):
    """Returns None where the points belong to another facade."""
    places = [in_axes(frame, p) for p in points]
    if abs(quantile([p[2] for p in places], 0.5)) > BESIDE:
        return None
    return [quantile([p[k] for p in places], share) for k in range(2) for share in (TAIL, 1 - TAIL)]


def pairs(labelled, facades):
    """Returns for each label (best intersection over union, the drawn element), where each drawn element is used once,
    and the number of drawn elements."""
    scores, drawn = [], 0
    for facade in facades:
        boxes = [(name, box_of_points(facade["frame"], points)) for name, points in labelled]
        for e in facade["elements"]:
            if not e["opening"]:
                continue
            drawn += 1
            ring = [in_axes(facade["frame"], p) for p in e["ring"]]
            own = [f(p[k] for p in ring) for k in range(2) for f in (min, max)]
            scores += [(overlap(own, box), name, (facade["facade"], e["id"]), e["kind"]) for name, box in boxes if box]
    of_label, used = {}, set()
    for score, name, key, kind in sorted(scores, reverse=True):
        if score > 0 and name not in of_label and key not in used:
            of_label[name] = (score, kind)
            used.add(key)
    return of_label, drawn


def report(name, scores, drawn, right_kind):
    found = sum(s >= FOUND for s in scores)
    counts = [sum(s >= step for s in scores) for step in STEPS]
    print(f"| {name} | {len(scores)} | {found} ({100 * found / len(scores):.0f} %) | {drawn} | "
          f"{100 * found / max(1, drawn):.0f} % | {right_kind} | " + " / ".join(str(c) for c in counts) +
          f" | {quantile(scores, 0.5):.2f}, {min(scores):.2f} |", flush=True)


def main():
    options = arguments()
    if "ILOT_DATA" not in os.environ:
        sys.exit("bench/labelled_openings.py: ILOT_DATA names no folder of clouds: nothing to measure")
    print("| facade | labelled | found | drawn | of these found | window or door as labelled | " +
          " / ".join(str(s) for s in STEPS) + " and more | median, least |")
    print("|---|---|---|---|---|---|---|---|", flush=True)
    everything, all_drawn, all_right = [], 0, 0
    with tempfile.TemporaryDirectory() as work:
        for facade in sorted((pathlib.Path(os.environ["ILOT_DATA"]) / "facades/nuist").glob("*/*")):
            name = f"{facade.parent.name}/{facade.name}"
            folder = pathlib.Path(options.keep or work) / name.replace("/", "-")
            folder.mkdir(parents=True, exist_ok=True)
            labelled = [(f.stem, points_of(f)) for f in sorted(facade.glob("*.txt"))]
            facades = run(options, labelled, folder)
            openings = [(n, p) for n, p in labelled if not n.startswith("wall")]
            of_label, drawn = pairs(openings, facades)
            scores = [of_label.get(n, (0, ""))[0] for n, _ in openings]
            right = sum(s >= FOUND and n.startswith(kind) for n, (s, kind) in of_label.items())
            report(name, scores, drawn, right)
            if options.list:
                for n, _ in openings:
                    print(f"  {n}: {of_label.get(n, (0, 'none'))[0]:.3f} {of_label.get(n, (0, 'none'))[1]}")
            everything, all_drawn, all_right = everything + scores, all_drawn + drawn, all_right + right
    report("all", everything, all_drawn, all_right)


if __name__ == "__main__":
    main()
