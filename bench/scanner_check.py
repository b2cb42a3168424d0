#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares points of the virtual scanner with points of real scanners: echoes by distance and incidence, range noise on
flat patches, points between two surfaces, holes, intensity; and asks a simple classifier over local features whether it
can tell them apart. Needs ILOT_DATA and python3-numpy, python3-scipy, python3-sklearn.

The classifier learns on some clouds and is judged on others: of the real ones on another tile, scan or building, of
ours on another scene or seed. AUC 0.5 means that it cannot tell them apart, 1 that it always can.

usage: /usr/bin/python3 bench/scanner_check.py [ILOT] [--only air wild-air vehicle ...] [--keep FOLDER]
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from scipy.spatial import cKDTree
from sklearn.ensemble import GradientBoostingClassifier
from sklearn.metrics import roc_auc_score

ROOT = pathlib.Path(__file__).resolve().parent.parent
NEAR, SHORT = 20, 8  # neighbours of shape and of the pattern of lines
SAMPLE = 12000  # points of a cloud that are described
FEATURES = {"shape": ["linearity", "planarity", "sphericity", "roughness over spacing", "lean"],
            "pattern": ["nearest over 20th distance", "4th over 20th distance", "points within twice the 10th", "line of 8"],
            "noise": ["residual, m"], "density": ["log density"],
            "intensity": ["local spread of intensity", "intensity over median"], "returns": ["share of pulses with several"]}
GROUPS = [group + kind for group in ("", "wild-") for kind in ("air", "vehicle", "tripod", "facade")]
NAMES = [n for group in FEATURES.values() for n in group]
INCIDENCE = [(0, 30), (30, 60), (60, 75), (75, 82)]  # degrees; above, local density no longer tells the angle


def arguments():
    parser = argparse.ArgumentParser(prog="bench/scanner_check.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--only", nargs="*", help="groups of clouds [all]", default=GROUPS, choices=GROUPS)
    parser.add_argument("--keep", metavar="FOLDER", help="leave clouds there")
    return parser.parse_args()


def call(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(str(c) for c in command)}\n{done.stderr}")


class Cloud:
    """Points with intensity and returns. `origin` is the scanner's place where it is known."""

    def __init__(self, name, real, use, places, intensity, returns, origin=None):
        self.name, self.real, self.use, self.origin = name, real, use, origin
        self.places, self.intensity, self.returns = places, intensity, returns
        self.tree = cKDTree(places)
        chosen = np.random.default_rng(1).permutation(len(places))[:SAMPLE]
        self.sample = np.sort(chosen)
        self.describe()

    def describe(self):
        distance, index = self.tree.query(self.places[self.sample], k=NEAR + 1)
        near = self.places[index]
        self.index, self.reach = index, np.maximum(distance[:, NEAR], 1e-6)
        values, vectors = np.linalg.eigh(np.einsum("nki,nkj->nij", *(2 * [near - near.mean(1, keepdims=True)])) / (NEAR + 1))
        l1, l2, l3 = (np.sqrt(np.maximum(values[:, k], 0)) for k in (2, 1, 0))
        self.normal, self.residual = vectors[:, :, 0], l3
        short = near[:, :SHORT + 1] - near[:, :SHORT + 1].mean(1, keepdims=True)
        s = np.sqrt(np.maximum(np.linalg.eigvalsh(np.einsum("nki,nkj->nij", short, short)), 0))
        wide = self.tree.query_ball_point(self.places[self.sample], 2 * np.maximum(distance[:, 10], 1e-6), return_length=True)
        self.flat = (l2 > 0.25 * l1) & (l3 < 0.15 * l2)
        self.density = NEAR / (np.pi * self.reach ** 2)
        bright = self.intensity[index].astype(float)
        spread = bright.std(1) / np.maximum(bright.mean(1), 1e-9)
        middle = max(float(np.median(self.intensity)), 1e-9)
        self.features = np.column_stack([
            (l1 - l2) / np.maximum(l1, 1e-9), (l2 - l3) / np.maximum(l1, 1e-9), l3 / np.maximum(l1, 1e-9),
            l3 / self.reach, np.abs(self.normal[:, 2]), distance[:, 1] / self.reach, distance[:, 4] / self.reach, wide / 10,
            (s[:, 2] - s[:, 1]) / np.maximum(s[:, 2], 1e-9), l3, np.log(self.density), spread,
            np.minimum(self.intensity[self.sample] / middle, 10), (self.returns[index] > 1).mean(1)])
        self.spread = spread


def read_csv(path, keep=None):
    with open(path) as file:
        names = file.readline().strip().split(",")
    table = np.loadtxt(path, delimiter=",", skiprows=1, usecols=[names.index(n) for n in
                                                                ("x", "y", "z", "intensity", "number_of_returns",
                                                                 "classification")])
    return table if keep is None else table[keep(table)]


class Source:
    """Makes clouds of files and of scans."""

    def __init__(self, options, folder):
        self.ilot, self.folder = options.ilot, folder
        self.data = pathlib.Path(os.environ["ILOT_DATA"])

    def table(self, path, keep=None):
        text = self.folder / (pathlib.Path(path).stem + ".csv")
        call(self.ilot, "convert", path, text, "--overwrite", "-q")
        return read_csv(text, keep)

    def real(self, name, use, file, keep=None, origin=None):
        return self.cloud(name, True, use, self.table(self.data / file, keep), origin)

    def ours(self, name, use, scan, keep=None, origin=None):
        cloud = self.folder / (name.replace(" ", "-").replace(",", "") + ".laz")
        call(self.ilot, "scan", *scan, "-o", cloud, "--overwrite", "-q")
        if origin == "station":
            row = cloud.with_suffix(".stations.csv").read_text().splitlines()[1].split(",")
            origin = [float(c) for c in row[1:4]]
        return self.cloud(name, False, use, self.table(cloud, keep), origin)

    def cloud(self, name, real, use, table, origin):
        if origin is not None:  # some formats write pulses without an echo at the scanner's own place
            table = table[np.linalg.norm(table[:, :3] - origin, axis=1) > 0.3]
        low = table[:, :3].min(0)
        return Cloud(name, real, use, table[:, :3] - low, table[:, 3], table[:, 4],
                     None if origin is None else np.asarray(origin, float) - low)

    def nuist(self, name, use, building):
        rows = [np.loadtxt(f, usecols=(0, 1, 2, 3)) for f in sorted((self.data / "facades/nuist" / building).rglob("*.txt"))]
        table = np.vstack(rows)
        return self.cloud(name, True, use, np.column_stack([table, np.ones((len(table), 2))]), None)


def square(metres, height):
    """Keeps a square around the middle of the points, cut at a height as the real street is."""
    def keep(table):
        off = np.abs(table[:, :2] - np.median(table[:, :2], axis=0)).max(1)
        inside = off < metres / 2
        return inside & (table[:, 2] < np.quantile(table[inside, 2], 0.01) + height)
    return keep


def real_clouds(kind, source):
    if kind == "air":
        return [source.real("ign 77055", "learn", "ign/77055_627755_pf8.laz"),
                source.real("amsterdam ahn", "learn", "amsterdam/ahn_2386_9702.laz"),
                source.real("ign 77060", "judge", "ign/77060_627755_pf8.laz")]
    if kind == "vehicle":
        half = lambda side: lambda table: (table[:, 0] < np.median(table[:, 0])) == side
        return [source.real("amsterdam sidewalk, west", "learn", "amsterdam/run2_sidewalk_2386_9702.laz", half(True)),
                source.real("amsterdam sidewalk, east", "judge", "amsterdam/run2_sidewalk_2386_9702.laz", half(False))]
    if kind == "tripod":
        return [source.real("small source", "learn", "small/source.ply", origin=[0, 0, 0]),
                source.real("small target", "judge", "small/target.ply", origin=[0, 0, 0])]
    return [source.nuist("nuist 1", "learn", "building_1"), source.nuist("nuist 3", "judge", "building_3")]


def tidy_clouds(kind, source):
    """The scenes of documents and models of others."""
    model = lambda number: ["--model", source.data / "lod3" / f"{number}.city.json"]
    if kind == "air":
        air = ["--set", "scene.blocks=2", "--set", "scene.density=27"]
        return [source.ours("street-air seed 1", "learn", ["street-air", "--seed", 1, *air]),
                source.ours("model 4018215, flight", "learn", [*model(4018215), "--flight"]),
                source.ours("street-air seed 2", "judge", ["street-air", "--seed", 2, *air])]
    if kind == "vehicle":
        drive = ["--set", "scene.blocks=1", "--points", 1200000]
        return [source.ours("street seed 1", "learn", ["street", "--seed", 1, *drive], square(30, 3)),
                source.ours("model 4018215, vehicle", "learn", [*model(4018215), "--vehicle", "--points", 800000], square(60, 3)),
                source.ours("street seed 2", "judge", ["street", "--seed", 2, *drive], square(30, 3))]
    if kind == "tripod":
        tripod = ["--points", 120000]
        return [source.ours("facade-restoration", "learn", ["facade-restoration", *tripod], origin="station"),
                source.ours("stones", "learn", ["stones", *tripod], origin="station"),
                source.ours("model 4018154", "judge", [*model(4018154), "--stations", *tripod])]
    return [source.ours("facade-haussmann", "learn", ["facade-haussmann", "--points", 60000]),
            source.ours("facade-restoration", "judge", ["facade-restoration", "--points", 40000])]


def wild_clouds(kind, source):
    """Wild scenes of four seeds to learn from and of four others to judge on; facades have intensity, as the real ones have."""
    def scenes(scene, settings, keep=None):
        drawn = [part for setting in settings for part in ("--set", f"scene.{setting}")]
        return [source.ours(f"{scene} {kind} seed {seed}", "learn" if seed < 4 else "judge",
                            [scene, "--seed", seed, "--points", 400000, *drawn], keep) for seed in range(8)]
    if kind == "facade":
        return scenes("facade-wild", ["intensity=corrected"])
    return scenes("street-wild", [f"street.platform={kind}"], square(30, 3) if kind == "vehicle" else None)


def clouds_of(group, source):
    kind = group.removeprefix("wild-")
    return real_clouds(kind, source) + (wild_clouds if group != kind else tidy_clouds)(kind, source)


def quantiles(values, digits=4):
    return " / ".join(f"{q:.{digits}f}" for q in np.quantile(values, (0.1, 0.5, 0.9))) if len(values) else "-"


def holes(cloud):
    """Share of empty cells with points on both sides in a row and in a column: of the picture from the scanner, or of
    the plan. Cells hold four points where the cloud is as dense as usual."""
    if cloud.origin is not None:
        way = cloud.places - cloud.origin
        flat = np.column_stack([np.arctan2(way[:, 1], way[:, 0]), np.arctan2(way[:, 2], np.hypot(way[:, 0], way[:, 1]))])
        pitch = np.median(cKDTree(flat).query(flat[cloud.sample], k=5)[0][:, 4])
    else:
        flat, pitch = cloud.places[:, :2], np.median(np.sqrt(1 / cloud.density))
    cell = np.floor((flat - flat.min(0)) / (2 * max(pitch, 1e-9))).astype(int)
    size = cell.max(0) + 1
    if size.prod() > 5e7:
        return float("nan")
    full = np.zeros(size, bool)
    full[cell[:, 0], cell[:, 1]] = True
    inside = np.ones_like(full)
    for axis in (0, 1):
        before = np.maximum.accumulate(full, axis)
        after = np.flip(np.maximum.accumulate(np.flip(full, axis), axis), axis)
        inside &= before & after
    return float((inside & ~full).sum() / max(1, inside.sum()))


def between(cloud):
    """Share of points that hang between a nearer and a farther surface: among those whose ten nearest directions differ
    in range by 10 cm or more, those with no neighbour within 3 cm of their range, some nearer and some farther."""
    way = cloud.places - cloud.origin
    reach = np.linalg.norm(way, axis=1)
    tree = cKDTree(way / reach[:, None])
    index = tree.query(tree.data[cloud.sample], k=11)[1][:, 1:]
    off = reach[index] - reach[cloud.sample][:, None]
    edge = np.ptp(off, axis=1) > 0.1
    mixed = edge & (np.abs(off) > 0.03).all(1) & (off < 0).any(1) & (off > 0).any(1)
    return float(mixed.mean()), float(mixed.sum() / max(1, edge.sum()))


def incidence_of(cloud):
    """Angle between ray and normal in degrees, and echoes per steradian (or per m2 of plan) over their median."""
    if cloud.origin is None:
        cosine = np.abs(cloud.normal[:, 2])
        rate = cloud.density / np.maximum(cosine, 1e-3)
    else:
        way = cloud.places[cloud.sample] - cloud.origin
        reach = np.linalg.norm(way, axis=1)
        cosine = np.abs((cloud.normal * way).sum(1)) / reach
        rate = cloud.density * reach ** 2 / np.maximum(cosine, 1e-3)
    angle = np.degrees(np.arccos(np.clip(cosine, 0, 1)))
    front = cloud.flat & (angle < 60)
    return angle, rate / (np.median(rate[front]) if front.any() else 1)


def scatter(cloud):
    """Share of points that are four times as far from their 4th neighbour as their neighbours are from theirs."""
    fourth = cloud.tree.query(cloud.places, k=5)[0][:, 4]
    usual = np.median(fourth[cloud.index], axis=1)
    return float((fourth[cloud.sample] > 4 * usual).mean())


def report_numbers(group, clouds):
    print(f"\n### {group}: numbers\n")
    print("| cloud | points | density, /m2, 10/50/90 % | residual on flat patches, mm, 10/50/90 % | loose points | between two "
          "surfaces (of those at edges) | holes | spread of intensity on flat patches, 50 % | several returns |")
    print("|---|---|---|---|---|---|---|---|---|")
    for c in clouds:
        mixed = "-" if c.origin is None else "{:.2%} ({:.0%})".format(*between(c))
        shown = f"{np.median(c.spread[c.flat]):.2f}" if c.flat.any() and c.intensity.max() > c.intensity.min() else "-"
        print(f"| {'real' if c.real else 'ours'}: {c.name} | {len(c.places):,} | {quantiles(c.density, 0)} | "
              f"{quantiles(1000 * c.residual[c.flat], 1)} | {scatter(c):.2%} | {mixed} | {holes(c):.1%} | {shown} | "
              f"{(c.returns > 1).mean():.1%} |", flush=True)
    print("\nEchoes by incidence on flat patches, 1 = as many as the same angle of directions (tripod) or plan gets below "
          "60 degrees; in brackets the share of the points\n")
    print("| cloud | " + " | ".join(f"{a} to {b} deg" for a, b in INCIDENCE) + " |")
    print("|---" * (len(INCIDENCE) + 1) + "|")
    for c in clouds:
        if c.origin is None and group != "air":
            continue  # nothing tells where its rays come from
        angle, rate = incidence_of(c)
        cells = []
        for a, b in INCIDENCE:
            chosen = c.flat & (angle >= a) & (angle < b)
            cells.append(f"{np.median(rate[chosen]):.2f} ({chosen.mean():.1%})" if chosen.sum() > 20 else "-")
        print(f"| {'real' if c.real else 'ours'}: {c.name} | " + " | ".join(cells) + " |", flush=True)


def learnt_auc(clouds, columns):
    def rows(use):
        some = [c for c in clouds if c.use == use]
        # Both kinds weigh the same, whatever the number of their clouds.
        weight = [np.full(len(c.sample), 1 / sum(len(o.sample) for o in some if o.real == c.real)) for c in some]
        return (np.vstack([c.features[:, columns] for c in some]),
                np.concatenate([np.full(len(c.sample), not c.real) for c in some]), np.concatenate(weight))
    x, y, w = rows("learn")
    model = GradientBoostingClassifier(n_estimators=80, max_depth=3, subsample=0.5, random_state=0).fit(x, y, w / w.mean())
    x, y, w = rows("judge")
    return roc_auc_score(y, model.predict_proba(x)[:, 1], sample_weight=w)


def report_classifier(group, clouds):
    print(f"\n### {group}: can a classifier tell them apart?\n")
    bright = all(c.intensity.max() > c.intensity.min() for c in clouds)
    groups = [g for g in FEATURES if bright or g != "intensity"]  # what a cloud does not have tells nothing
    columns = lambda names: [NAMES.index(n) for g in names for n in FEATURES[g]]
    print("| features | AUC |\n|---|---|")
    for names in (groups, [g for g in groups if g != "density"], *([g] for g in groups)):
        print(f"| {', '.join(names)} | {learnt_auc(clouds, columns(names)):.3f} |", flush=True)
    judged = [c for c in clouds if c.use == "judge"]
    x = np.vstack([c.features for c in judged])
    y = np.concatenate([np.full(len(c.sample), not c.real) for c in judged])
    single = sorted(((abs(roc_auc_score(y, x[:, k]) - 0.5) + 0.5, NAMES[k]) for k in columns(groups)), reverse=True)
    print("\nSingle features that differ most on the judged clouds: " + ", ".join(f"{n} {a:.2f}" for a, n in single[:5]))


def main():
    options = arguments()
    if "ILOT_DATA" not in os.environ:
        sys.exit("bench/scanner_check.py: ILOT_DATA names no folder of clouds: nothing to compare")
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(options.keep or work)
        folder.mkdir(parents=True, exist_ok=True)
        for group in options.only:
            clouds = clouds_of(group, Source(options, folder))
            report_numbers(group, clouds)
            report_classifier(group, clouds)


if __name__ == "__main__":
    main()
