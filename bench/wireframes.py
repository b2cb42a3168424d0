#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Judges the edges of roofs by the corrected wireframes of Building3D (`ilot evaluate --wireframe`): each cloud is one
building without classes and ground. Each roof is made twice: with the true outline (the outer ring of the wireframe seen
from above), and without an outline. The two halves are every second roof by name: the method was worked on with the first
one, the result is the figure of the second one. Needs ILOT_DATA.

usage: bench/wireframes.py [ILOT] [--maker ILOT] [--half worked_on|others|both] [--only NAME ...]
           [--set KEY=VALUE ...] [--keep FOLDER] [--list]
"""
import argparse
import gzip
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SAME = 0.02  # metres in plan within which corners of a wireframe are one, and a corner is on an edge


def arguments():
    parser = argparse.ArgumentParser(prog="bench/wireframes.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--maker", metavar="ILOT", help="an earlier program that makes the models; the first one judges")
    parser.add_argument("--half", choices=("worked_on", "others", "both"), default="both")
    parser.add_argument("--only", nargs="*", metavar="NAME", help="these roofs alone")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="a setting of the runs")
    parser.add_argument("--keep", metavar="FOLDER", help="leave clouds, outlines and results there")
    parser.add_argument("--list", action="store_true", help="also a row for each roof")
    return parser.parse_args()


def edges_in_plan(wireframe):
    """Returns the corners in plan, those within SAME joined, and the edges between them without upright ones."""
    corners, number, edges = [], [], []
    for line in open(wireframe):
        words = line.split()
        if words[:1] == ["v"]:
            p = (float(words[1]), float(words[2]))
            near = [i for i, q in enumerate(corners) if math.dist(p, q) <= SAME]
            if not near:
                corners.append(p)
            number.append(near[0] if near else len(corners) - 1)
        elif words[:1] == ["l"]:
            ends = [number[int(w) - 1] for w in words[1:]]
            edges += [(a, b) for a, b in zip(ends, ends[1:]) if a != b]
    return corners, edges


def crossing(p, q, r, s):
    """Returns where two segments cross, or None."""
    d, e = (q[0] - p[0], q[1] - p[1]), (s[0] - r[0], s[1] - r[1])
    area = d[0] * e[1] - d[1] * e[0]
    if abs(area) < 1e-12:
        return None
    t = ((r[0] - p[0]) * e[1] - (r[1] - p[1]) * e[0]) / area
    u = ((r[0] - p[0]) * d[1] - (r[1] - p[1]) * d[0]) / area
    return (p[0] + t * d[0], p[1] + t * d[1]) if 0 < t < 1 and 0 < u < 1 else None


def split_edges(corners, edges):
    """Returns corners and edges that meet only in corners."""
    corners = list(corners)
    for i, (a, b) in enumerate(edges):
        for c, d in edges[:i]:
            at = crossing(corners[a], corners[b], corners[c], corners[d])
            if at and all(math.dist(at, p) > SAME for p in corners):
                corners.append(at)
    pieces = set()
    for a, b in edges:
        p, q = corners[a], corners[b]
        length = math.dist(p, q)
        on = []
        for i, c in enumerate(corners):
            t = ((c[0] - p[0]) * (q[0] - p[0]) + (c[1] - p[1]) * (q[1] - p[1])) / length
            away = abs((c[0] - p[0]) * (q[1] - p[1]) - (c[1] - p[1]) * (q[0] - p[0])) / length
            if i in (a, b) or (away <= SAME and 0 < t < length):
                on.append((0 if i == a else length if i == b else t, i))
        on.sort()
        pieces |= {tuple(sorted((i, j))) for (_, i), (_, j) in zip(on, on[1:])}
    return corners, pieces


def outer_rings(corners, edges):
    """Returns the outer ring of each connected part: from its leftmost corner always along the rightmost edge. Parts that
    stand within another part, such as dormers, have none of their own: from above they are not at the border."""
    around = {}
    for a, b in edges:
        around.setdefault(a, []).append(b)
        around.setdefault(b, []).append(a)

    def heading(a, b):
        return math.atan2(corners[b][1] - corners[a][1], corners[b][0] - corners[a][0])
    rings, left = [], set(around)
    while left:
        part, stack = set(), [next(iter(left))]
        while stack:
            i = stack.pop()
            if i not in part:
                part.add(i)
                stack += around[i]
        left -= part
        start = min(part, key=lambda i: corners[i])
        ring, at, back = [], start, math.pi
        first = None
        while True:
            after = min(around[at], key=lambda j: ((heading(at, j) - back) % (2 * math.pi)) or 2 * math.pi)
            if first == (at, after):
                break
            first = first or (at, after)
            ring.append(at)
            at, back = after, heading(after, at)
        rings.append(without_spikes(ring, corners))
    rings = [r for r in rings if len(r) >= 3]
    return [r for r in rings if not any(other is not r and all(within(c, other) for c in r) for other in rings)]


def within(p, ring):
    """Returns whether a point is in a ring, by the edges that a ray from it crosses."""
    crossed = 0
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > p[1]) != (by > p[1]) and p[0] < ax + (p[1] - ay) / (by - ay) * (bx - ax):
            crossed += 1
    return crossed % 2 == 1


def without_spikes(ring, corners):
    """Leaves out edges that the ring goes along in both directions."""
    changed = True
    while changed and len(ring) >= 3:
        changed = False
        for i in range(len(ring)):
            if ring[i - 1] == ring[(i + 1) % len(ring)]:
                ring = [c for k, c in enumerate(ring) if k not in (i, (i + 1) % len(ring))]
                changed = True
                break
    return [corners[i] for i in ring]


def write_outline(wireframe, path):
    rings = outer_rings(*split_edges(*edges_in_plan(wireframe)))
    features = [{"type": "Feature", "properties": {"id": str(n)},
                 "geometry": {"type": "Polygon", "coordinates": [[*map(list, ring), list(ring[0])]]}}
                for n, ring in enumerate(rings)]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))


def call(command, codes=(0, 3)):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode not in codes:
        sys.exit(f"{' '.join(str(c) for c in command)}\n{done.stderr}")
    return done.stdout


def judge(options, wireframe, folder, with_outline):
    cloud = folder / f"{wireframe.stem}.xyz"
    with gzip.open(wireframe.with_suffix(".xyz.gz"), "rt") as source:
        cloud.write_text("".join(" ".join(line.split()[:3]) + "\n" for line in source))
    out = folder / f"{wireframe.stem}_{'outline' if with_outline else 'none'}"
    command = [options.maker or options.ilot, "run", cloud, "-o", out, "--overwrite", "--products", "roofs", "-q",
               "--crs", "EPSG:3301", "--set", "classes.building=[0,1,6]"]
    for setting in options.set:
        command += ["--set", setting]
    if with_outline:
        outline = folder / f"{wireframe.stem}.geojson"
        write_outline(wireframe, outline)
        command += ["--footprints", outline]
    call(command)
    edges = json.loads(call([options.ilot, "evaluate", out, "--wireframe", wireframe, "--json"]))["all"]
    fit = json.loads(call([options.ilot, "evaluate", "--models", out / "roofs/roofs.city.jsonl", "--cloud", cloud, "--json",
                           "--faces", "all", "--points-of", "plan", "--margin", "1000"]))["over_points"]
    return edges | {"rmse_m": fit["rmse_m"]}


def line(name, outlines, rows):
    total = {k: sum(r[k] for r in rows) for k in ("true", "drawn", "matched", "matched_close", "judged_length", "short")}
    corners = sum((r["corner_offset_m"] or 0) * r["matched"] for r in rows)
    rmse = sorted(r["rmse_m"] if r["rmse_m"] is not None else math.inf for r in rows)

    def share(part, whole):
        return f"{part / whole:.3f}" if whole else "-"
    both = total["true"] + total["drawn"]
    print(f"| {name} | {outlines} | {total['true']} | {total['drawn']} | {share(total['matched'], total['drawn'])} | "
          f"{share(total['matched'], total['true'])} | {share(2 * total['matched'], both)} | "
          f"{share(2 * total['matched_close'], both)} | {share(total['drawn'], total['true'])} | "
          f"{share(corners, total['matched'])} | {share(total['short'], total['judged_length'])} | "
          f"{rmse[(len(rmse) - 1) // 2]:.3f} |", flush=True)


def main():
    options = arguments()
    if "ILOT_DATA" not in os.environ:
        sys.exit("bench/wireframes.py: ILOT_DATA names no folder of clouds: nothing to measure")
    roofs = sorted((pathlib.Path(os.environ["ILOT_DATA"]) / "roofs/building3d").glob("*.obj"))
    halves = {"worked_on": roofs[0::2], "others": roofs[1::2]}
    print("| roofs | outlines | true edges | drawn | precision | recall | F1 | F1 within 0.3 m | drawn over true | "
          "corners off by, m | under 0.5 m | RMSE median, m |\n|" + "---|" * 12)
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(options.keep or work)
        folder.mkdir(parents=True, exist_ok=True)
        for half, members in halves.items():
            if options.half not in (half, "both"):
                continue
            for with_outline in (True, False):
                rows = []
                for wireframe in members:
                    if options.only and wireframe.stem not in options.only:
                        continue
                    rows.append(judge(options, wireframe, folder, with_outline))
                    if options.list:
                        line(wireframe.stem, "true" if with_outline else "none", rows[-1:])
                if rows:
                    line(half, "true" if with_outline else "none", rows)


if __name__ == "__main__":
    main()
