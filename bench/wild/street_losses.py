#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Why objects of wild streets are lost: counts by scanner and cause, over scenes that were scanned and run.

A true object is found if it and one object of the run have half of their points in common, as `ilot evaluate` has it.
The cause of a loss is where most of its points went:
  merged       one found object has half of its points or more, and many others: with another true object, or with
               points of none (a tree, a wall, ground)
  split        found objects have half of its points together, none of them alone
  wall, roof, ground
               points got the label of what stands beside or below it
  crown        labelled vegetation because a crown is above it (most of these points are 2.5 m or higher)
  vegetation   a candidate that the classifier took for a plant
  nothing      a candidate that the classifier took for no object, or that was too small to be one
  mixed        none of these has half of its points
Objects with fewer points than --least are counted apart: found and lost.

usage: bench/wild/street_losses.py FOLDER... [--least 50] [--exe ilot] [--list]
       each FOLDER holds a run of --products streets of FOLDER/../scene.laz (as bench/wild/run --keep leaves them), or of
       ../../NAME.laz, where NAME is that of the folder
"""
import argparse
import collections
import csv
import json
import pathlib
import subprocess
import tempfile

import numpy as np

import figures

LABELS = {0: "nothing", 1: "ground", 2: "roof", 3: "wall", 4: "vegetation", 5: "wall"}
HIGH = 2.5  # metres above the base; lower points below a crown are not those of the crown
CAUSES = ["merged with another object", "merged with no object", "split", "wall", "roof", "ground", "crown", "vegetation",
          "nothing", "mixed"]


def points_of(exe, cloud):
    with tempfile.TemporaryDirectory() as folder:
        text = pathlib.Path(folder) / "points.csv"
        subprocess.run([exe, "convert", cloud, text, "--overwrite", "-q"], check=True)
        with open(text) as file:
            names = next(csv.reader(file))
        wanted = ["z", "true_element", "object_id", "label"]
        return np.loadtxt(text, delimiter=",", skiprows=1, usecols=[names.index(n) for n in wanted])


def pairs_of(element, found):
    """Points in common of each true and each found object, and points of each."""
    both = collections.Counter(zip(element.tolist(), found.tolist()))
    of_true, of_found = collections.Counter(element.tolist()), collections.Counter(found.tolist())
    return both, of_true, of_found


def cause_of(base_z, own, common, of_found, of_true, both):
    """`own`: rows of the points of the object; `common`: points by found object."""
    n = len(own)
    best, most = max(common.items(), key=lambda c: c[1], default=(0, 0))
    if 2 * most >= n:
        others = [both[t, best] for t in of_true if t != 0 and both.get((t, best), 0) != most]
        largest = max(others, default=0)
        return CAUSES[0] if 4 * largest >= of_found[best] else CAUSES[1]
    if 2 * sum(common.values()) >= n:
        return "split"
    names = collections.Counter(LABELS.get(int(v), "") for v in own[own[:, 2] == 0][:, 3])
    name, count = names.most_common(1)[0]
    if 2 * count < n:
        return "mixed"
    if name == "vegetation":
        plants = own[(own[:, 2] == 0) & (own[:, 3] == 4)]
        return "crown" if 2 * np.count_nonzero(plants[:, 0] - base_z >= HIGH) >= len(plants) else "vegetation"
    return name


def losses_of(folder, truth_file, exe):
    """(class, variant, points, cause) of each true object with points; cause 'found' where it is found."""
    truth = json.loads(truth_file.read_text())
    cloud = next((folder / "points").glob("*.laz"))
    points = points_of(exe, cloud)
    both, of_true, of_found = pairs_of(points[:, 1].astype(int), points[:, 2].astype(int))
    rows = []
    for o in truth["objects"]:
        n = of_true.get(o["id"], 0)
        if n == 0:
            continue
        common = {f: c for (t, f), c in both.items() if t == o["id"] and f != 0}
        found = any(2 * c >= of_found[f] + n - c for f, c in common.items())
        own = points[points[:, 1] == o["id"]]
        cause = "found" if found else cause_of(o["base"][2], own, common, of_found, of_true, both)
        rows.append((o["class"], o["variant"], n, cause, o["id"]))
    return figures.scanner_of(truth_file), rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--least", type=int, default=50, help="points of an object that a method should find")
    parser.add_argument("--exe", default="build/release/tools/ilot")
    parser.add_argument("--list", action="store_true", help="each lost object")
    options = parser.parse_args()
    tables = collections.defaultdict(collections.Counter)
    variants = collections.defaultdict(collections.Counter)
    for folder in options.folders:
        truth = folder.parent / "scene.truth.json"
        if not truth.exists():
            truth = folder.parent.parent / (folder.name + ".truth.json")
        scanner, rows = losses_of(folder, truth, options.exe)
        for name, variant, n, cause, number in rows:
            few = "" if n >= options.least else "few points: "
            tables[scanner][few + ("found" if cause == "found" else "lost" if few else cause)] += 1
            if not few:
                variants[cause][variant] += 1
            if options.list and not few and cause != "found":
                print(folder.name, number, name, variant, n, cause)
    scanners = sorted(tables)
    print("| | " + " | ".join(scanners) + " | all | most of these are |")
    print("|---|" + "---|" * (len(scanners) + 2))
    for cause in ["found", *CAUSES, "few points: found", "few points: lost"]:
        counts = [tables[s][cause] for s in scanners]
        often = ", ".join(f"{v} {c}" for v, c in variants[cause].most_common(4))
        print(f"| {cause} | " + " | ".join(map(str, counts)) + f" | {sum(counts)} | {often} |")


if __name__ == "__main__":
    main()
