#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Learns the weights of engine/products/facades/elements/opening_odds.cpp: the odds that what is drawn as an opening is
one. Scans wild scenes, draws their facades with every opening that is found (facades.keep_unlikely), pairs drawn and
true openings as `ilot evaluate` does (half of their union in common, planes within 30 cm), and fits a logistic
regression (Cox 1958) by Newton's method. Prints the weights, and what they say of scenes they were not learnt from.
Right openings lower than 1 m count four times: of the windows of models of real houses (LoD3) 8 % are so low, of those of
the scenes 2 %.

  bench/wild/opening_odds.py PROGRAM FOLDER --seeds 10000000-10000099 --judge 900-919 [--points 300000] [--jobs 2]
  bench/wild/opening_odds.py PROGRAM FOLDER --seeds 10000000-10000099 --results OTHER/*/   # folders with out/ and *.truth.json

Seeds that models are learnt from begin at 10,000,000; those below 1000 are for development. Scenes and results stay in
FOLDER and are used again. Needs numpy."""
import argparse
import concurrent.futures
import json
import pathlib
import subprocess

import numpy

import commands
from wall_frame import Frame, common, iou

SCENES = ["facade-wild", "row-wild", "court-wild"]
NAMES = ["ln greatest error / size", "ln least error", "ln 1 + in row", "ln 1 + alike", "height, 0.9 to 1.2 m", "depth",
         "ln gap", "off column", "|ln height / width|", "beside what nobody saw"]
NEAR = 0.3  # metres between the plane of an opening and what may be drawn of it
RIDGE = 1.0  # of the standardised weights, as one observation
LOW, LOW_COUNTS = 1.0, 4  # metres; how often a right opening counts that is lower


def box_on(facade, ring):
    """The box around a ring in the axes of its facade: left, right, bottom, top."""
    f = facade["frame"]
    flat = [[sum((p[i] - f["origin"][i]) * f[axis][i] for i in range(3)) for axis in ("right", "up")] for p in ring]
    return [pick(p[k] for p in flat) for k in (0, 1) for pick in (min, max)]


def is_measured_opening(e):
    return e["opening"] and e["region"] == "element" and e["ring"] and e["status"] not in ("occluded", "by hand")


def gap_between(a, b):
    return float(numpy.hypot(max(a[0] - b[1], b[0] - a[1], 0), max(a[2] - b[3], b[2] - a[3], 0)))


def values_of(facade):
    """The elements of a facade that are openings, and the values of opening_log_odds() for each."""
    openings = [(e, box_on(facade, e["ring"])) for e in facade["elements"] if is_measured_opening(e)]
    unseen = [box_on(facade, e["ring"]) for e in facade["elements"]
              if e["kind"] in ("possible opening", "not seen") and e["ring"]]
    rows = []
    for e, a in openings:
        others = [(o, b) for o, b in openings if o is not e]
        wide, high = e["width_m"], e["height_m"]
        errors = [edge["error_m"] for edge in e["edges"]]
        in_row = sum(abs(a[2] - b[2]) < 0.15 and abs(a[3] - b[3]) < 0.15 for _, b in others)
        alike = sum(abs(wide - o["width_m"]) <= 0.1 + 0.05 * wide and abs(high - o["height_m"]) <= 0.1 + 0.05 * high
                    for o, _ in others)
        gap = min((gap_between(a, b) for _, b in others), default=numpy.inf)
        off = min((abs(a[0] + a[1] - b[0] - b[1]) / 2 for _, b in others), default=numpy.inf)
        rows.append([numpy.log(numpy.clip(max(errors) / max(min(wide, high), 0.3), 0.005, 3)),
                     numpy.log(numpy.clip(min(errors), 0.003, 0.3)), numpy.log1p(min(in_row, 7)),
                     numpy.log1p(min(alike, 7)), numpy.clip(high, 0.9, 1.2), min(abs(e["depth_m"]), 0.5),
                     numpy.log(numpy.clip(gap, 0.05, 2)), min(off, 1), abs(numpy.log(numpy.clip(high / wide, 0.22, 4.5))),
                     float(any(gap_between(a, b) < 0.1 for b in unseen))])
    return [e for e, _ in openings], rows


def is_right(truth, elements):
    """Whether each drawn opening has a true one of its own."""
    places = [s["position"] for s in truth.get("stations", [])]
    pairs = []
    for t, o in enumerate(truth.get("openings", [])):
        frame = Frame(o["ring"], places)
        box = frame.box(o["ring"])
        for k, e in enumerate(elements):
            own = frame.box(e["ring"])
            if abs(frame.flat(e["ring"][0])[2]) <= NEAR and common(own, box) > 0 and iou(own, box) >= 0.5:
                pairs.append((-iou(own, box), t, k))
    taken, right = set(), set()
    for _, t, k in sorted(pairs):
        if t not in taken and k not in right:
            taken.add(t)
            right.add(k)
    return [k in right for k in range(len(elements))]


def samples_of(folder):
    """Values and truth of all openings in the result of one scene."""
    truth = json.loads(next(folder.glob("*.truth.json")).read_text())
    elements, rows = [], []
    for path in sorted((folder / "out" / "facades").glob("facade-*.json")):
        some, values = values_of(json.loads(path.read_text()))
        elements += some
        rows += values
    return numpy.array(rows).reshape(-1, len(NAMES)), numpy.array(is_right(truth, elements), bool)


def drawn(given, scene, seed):
    """The folder of a scene with its result, or None if a step failed. Makes what is not there."""
    folder = given.folder / f"{scene}-{seed}"
    if (folder / "out" / "run.json").exists():
        return folder
    folder.mkdir(parents=True, exist_ok=True)
    cloud = folder / "scene.laz"
    if not (folder / "scene.truth.json").exists():
        scan = commands.scan(given.program, scene, seed, cloud, points=given.points)
        if subprocess.run(scan, capture_output=True).returncode:
            return None
    run = commands.run(given.program, cloud, folder / "out", "facades")
    run += ["--set", "facades.keep_unlikely=true", "--no-report", "--no-clouds", "-q"]
    return folder if subprocess.run(run, capture_output=True).returncode in (0, 3) else None


def gathered(given, seeds):
    scenes = [(scene, seed) for seed in range(seeds[0], seeds[1] + 1) for scene in SCENES]
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        folders = [f for f in pool.map(lambda s: drawn(given, *s), scenes) if f is not None]
    samples = [samples_of(f) for f in folders]
    return numpy.concatenate([v for v, _ in samples]), numpy.concatenate([r for _, r in samples])


def fit(values, right):
    """Weights of the values and the constant, by Newton's method on standardised values."""
    counts = numpy.where(right & (values[:, NAMES.index("height, 0.9 to 1.2 m")] < LOW), LOW_COUNTS, 1)
    middle, spread = values.mean(0), values.std(0) + 1e-9
    x = numpy.c_[(values - middle) / spread, numpy.ones(len(values))]
    ridge = numpy.diag([RIDGE] * values.shape[1] + [0])
    w = numpy.zeros(x.shape[1])
    for _ in range(30):
        p = 1 / (1 + numpy.exp(-x @ w))
        w -= numpy.linalg.solve((x * (counts * p * (1 - p))[:, None]).T @ x + ridge, x.T @ (counts * (p - right)) + ridge @ w)
    return w[:-1] / spread, w[-1] - (w[:-1] / spread) @ middle


def judge(name, values, right, weights, constant):
    odds = values @ weights + constant
    p = 1 / (1 + numpy.exp(-odds))
    left_out = odds < 0
    print(f"{name}: {right.sum()} of {len(right)} drawn openings are right; left out are {(left_out & right).sum()} right ones and "
          f"{(left_out & ~right).sum()} in vain")
    limits, off = [0, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 1.01], 0
    for low, high in zip(limits, limits[1:]):
        some = (p >= low) & (p < high)
        if some.any():
            off += abs(p[some].sum() - right[some].sum())
            print(f"  probability {low:.2f} to {min(high, 1):.2f}: {some.sum():5d} openings, mean {p[some].mean():.3f}, "
                  f"right {right[some].mean():.3f}")
    print(f"  expected calibration error {off / len(right):.3f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seeds", type=commands.range_of, required=True, metavar="A-B", help="to learn from")
    parser.add_argument("--judge", type=commands.range_of, metavar="A-B", help="to judge the weights on")
    parser.add_argument("--results", nargs="*", type=pathlib.Path, default=[], help="folders of results to judge them on")
    parser.add_argument("--points", type=int, default=300000, help="points of a scene [300000]")
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    values, right = gathered(given, given.seeds)
    weights, constant = fit(values, right)
    for name, weight in zip(NAMES, weights):
        print(f"{weight:9.3f}  {name}")
    print(f"{constant:9.3f}  constant")
    judge("learnt from", values, right, weights, constant)
    if given.judge:
        judge("judged on", *gathered(given, given.judge), weights, constant)
    if given.results:
        samples = [samples_of(f) for f in given.results]
        judge("results", numpy.concatenate([v for v, _ in samples]), numpy.concatenate([r for _, r in samples]), weights,
              constant)


if __name__ == "__main__":
    main()
