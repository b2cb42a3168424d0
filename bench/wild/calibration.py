#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How far the probabilities of street objects can be believed, over the objects of many wild scenes together.

One scene has some 25 objects in ten bins, so that its own calibration error is mostly that of small numbers. Here the
bins of all scenes are added first: over all objects, for each class and for each scanner. The calibration error is the
mean of |stated - right| of the bins, weighted by their objects (Guo, Pleiss, Sun and Weinberger 2017). An object is
right where `ilot evaluate` says so: half of its points in common with a true one of its class.

With --fit, prints the lines `calibrated` for a model of objects (engine/products/streets/classes), by which the
probabilities of each class become true for the objects given: the log odds are scaled and moved (Platt 1999). The fit is
drawn towards no change by PRIOR objects of the bins in the middle, so that few objects change little. Fit on
development seeds that the model was not trained on, with a model without such lines.

usage: bench/wild/calibration.py FOLDER... [--exe ilot] [--fit]
       each FOLDER holds a run of --products streets of FOLDER/../scene.laz (as bench/wild/run --keep leaves them), or of
       ../../NAME.laz, where NAME is that of the folder
"""
import argparse
import collections
import json
import math
import pathlib
import subprocess

import figures

BINS = 10
PRIOR = 20  # objects that say that nothing is to be changed


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


def logit(p):
    p = min(max(p, 1e-4), 1 - 1e-4)
    return math.log(p / (1 - p))


def fitted(bins):
    """Slope and offset of the log odds with the greatest likelihood, by Newton's steps; the prior's objects are spread
    over the odds of 0.3 to 0.9 and right as often as stated."""
    prior = [0.3, 0.5, 0.7, 0.9]
    rows = [(logit(b[1] / b[0]), b[0], b[2]) for b in bins if b[0]]
    rows += [(logit(p), PRIOR / len(prior), p * PRIOR / len(prior)) for p in prior]
    slope, offset = 1.0, 0.0
    for _ in range(50):
        g0 = g1 = h00 = h01 = h11 = 0.0
        for x, n, right in rows:
            p = 1 / (1 + math.exp(-(slope * x + offset)))
            g0, g1 = g0 + right - n * p, g1 + x * (right - n * p)
            w = n * p * (1 - p)
            h00, h01, h11 = h00 + w, h01 + w * x, h11 + w * x * x
        det = h00 * h11 - h01 * h01
        offset, slope = offset + (h11 * g0 - h01 * g1) / det, slope + (h00 * g1 - h01 * g0) / det
    return slope, offset


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
    parser.add_argument("--fit", action="store_true", help="print lines for a model")
    options = parser.parse_args()
    pool = collections.defaultdict(lambda: [[0, 0.0, 0.0] for _ in range(BINS)])
    for folder in options.folders:
        truth = folder.parent / "scene.truth.json"
        if not truth.exists():
            truth = folder.parent.parent / (folder.name + ".truth.json")
        done = subprocess.run([options.exe, "evaluate", folder, "--truth", truth, "--json"], capture_output=True, text=True,
                              check=True)
        said = json.loads(done.stdout)["probabilities"]
        pooled(pool, "all", said["bins"])
        pooled(pool, figures.scanner_of(truth), said["bins"])
        for name, own in said["classes"].items():
            pooled(pool, "class " + name, own["bins"])
    if options.fit:
        for name in sorted(n for n in pool if n.startswith("class ") and any(b[0] for b in pool[n])):
            print("calibrated {:.4g} {:.4g} {}".format(*fitted(pool[name]), name.removeprefix("class ")))
        return
    print("| | objects | calibration error | stated, mean | right | share with 0.9 and more | of these right |")
    print("|---|---|---|---|---|---|---|")
    for name in sorted(pool):
        if any(b[0] for b in pool[name]):
            print(row_of(name, pool[name]))


if __name__ == "__main__":
    main()
