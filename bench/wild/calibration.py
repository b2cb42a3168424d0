#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How far the probabilities of street objects can be believed, over the objects of many wild scenes together.

One scene has some 25 objects in ten bins, so that its own calibration error is mostly that of small numbers. Here the
bins of all scenes are added first: over all objects, for each class and for each scanner. The calibration error is the
mean of |stated - right| of the bins, weighted by their objects (Guo, Pleiss, Sun and Weinberger 2017). An object is
right where `ilot evaluate` says so: half of its points in common with a true one of its class.

usage: bench/wild/calibration.py FOLDER... [--exe ilot]
       each FOLDER holds a run of --products streets of FOLDER/../scene.laz (as bench/wild/run --keep leaves them)
"""
import argparse
import collections
import json
import pathlib
import subprocess

import figures

BINS = 10


def pooled(pool, key, bins):
    """Adds the bins of one scene: counts, and sums of what was stated and of what was right."""
    for own, b in zip(pool[key], bins):
        if b["count"]:
            own[0] += b["count"]
            own[1] += b["count"] * b["mean_probability"]
            own[2] += b["count"] * b["right"]


def error_of(bins):
    count = sum(b[0] for b in bins)
    return sum(abs(b[1] - b[2]) for b in bins) / count if count else 0


def row_of(name, bins):
    count = sum(b[0] for b in bins)
    stated, right = (sum(b[k] for b in bins) / count for k in (1, 2))
    last = bins[-1]
    sure = f"{last[0] / count:.2f} | {last[2] / last[0]:.2f}" if last[0] else "0.00 | -"
    return f"| {name} | {count} | {error_of(bins):.3f} | {stated:.2f} | {right:.2f} | {sure} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--exe", default="build/release/tools/ilot")
    options = parser.parse_args()
    pool = collections.defaultdict(lambda: [[0, 0.0, 0.0] for _ in range(BINS)])
    for folder in options.folders:
        truth = folder.parent / "scene.truth.json"
        done = subprocess.run([options.exe, "evaluate", folder, "--truth", truth, "--json"], capture_output=True, text=True,
                              check=True)
        said = json.loads(done.stdout)["probabilities"]
        pooled(pool, "all", said["bins"])
        pooled(pool, figures.scanner_of(truth), said["bins"])
        for name, own in said["classes"].items():
            pooled(pool, "class " + name, own["bins"])
    print("| | objects | calibration error | stated, mean | right | share with 0.9 and more | of these right |")
    print("|---|---|---|---|---|---|---|")
    for name in sorted(pool):
        if any(b[0] for b in pool[name]):
            print(row_of(name, pool[name]))


if __name__ == "__main__":
    main()
