#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts what a draughtsman would correct on the plans of facades, by kind, over results of `ilot run --products facades`.

  bench/wild/plan_corrections.py RESULT [CLOUD.csv|CLOUD.npy] [TRUTH.json] ...  (--list: every place)

Each RESULT is a folder of a run; the cloud (columns x, y, z; `ilot convert`) and the truth that follow it belong to it.

  openings missing, in vain   with a truth: no drawn one, or no true one, has an intersection over union of half with it
  bare drawn as wall          with a cloud: squares of half a metre inside the outline in which no point lies from 1 m behind
                              the wall to 15 cm before it, and which no element covers, where the wall about them has twelve
                              points in such a square; counted as patches, and in square metres
  beyond the wall             elements of which more than 2 cm lies past the left or right end of the outline, hatched ones apart
  opening over the outline    a corner of an opening is more than 2 cm outside of the outline
  wrong overall size          no chain has the size of all walls drawn (outline, dormers, walls above or below it)
  no level                    the top of a wall drawn above the outline has no level
  level twice                 two levels with the same text
  notch                       the outline has a gap between higher stretches
Needs numpy."""
import argparse
import collections
import json
import pathlib
import re
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from facade_frame import in_axes, overlap  # noqa: E402

SIDE, PAST, BEHIND, BEFORE = 0.5, 0.02, 1.0, 0.15  # metres
ABOUT, EXPECTED = 5, 12  # cells of 0.1 m around a bare place; points in a square as dense as there, at least
WALLS_ABOVE = ("recess", "protrusion", "dormer")


def box(places):
    us, vs = [p[0] for p in places], [p[1] for p in places]
    return min(us), max(us), min(vs), max(vs)


def contains(ring, u, v):
    """Whether each place lies in the ring; u and v are arrays."""
    inside = numpy.zeros(u.shape, bool)
    for a, b in zip(ring, ring[1:] + ring[:1]):
        if a[1] != b[1]:
            inside ^= ((a[1] > v) != (b[1] > v)) & (u < a[0] + (b[0] - a[0]) * (v - a[1]) / (b[1] - a[1]))
    return inside


def distance_outside(ring, place):
    if contains(ring, numpy.array([place[0]]), numpy.array([place[1]]))[0]:
        return 0
    best = 1e9
    for a, b in zip(ring, ring[1:] + ring[:1]):
        d = numpy.array(b[:2]) - a[:2]
        t = numpy.clip(numpy.dot(numpy.array(place[:2]) - a[:2], d) / max(1e-12, numpy.dot(d, d)), 0, 1)
        best = min(best, float(numpy.hypot(*(numpy.array(place[:2]) - a[:2] - t * d))))
    return best


def opened(mask, n):
    """What squares of n cells of the mask cover."""
    sums = numpy.pad(mask.astype(int).cumsum(0).cumsum(1), ((1, 0), (1, 0)))
    if mask.shape[0] < n or mask.shape[1] < n:
        return numpy.zeros_like(mask)
    full = sums[n:, n:] - sums[:-n, n:] - sums[n:, :-n] + sums[:-n, :-n] == n * n
    covered = numpy.zeros_like(mask)
    for dr in range(n):
        for dc in range(n):
            covered[dr:dr + full.shape[0], dc:dc + full.shape[1]] |= full
    return covered


def patches(mask):
    todo, found = {tuple(i) for i in numpy.argwhere(mask)}, []
    while todo:
        first = min(todo)
        part, heap = [], [first]
        todo.discard(first)
        while heap:
            r, c = heap.pop()
            part.append((r, c))
            for near in ((r + 1, c), (r - 1, c), (r, c + 1), (r, c - 1)):
                if near in todo:
                    todo.discard(near)
                    heap.append(near)
        found.append(part)
    return found


def bare_places(frame, rings, cloud):
    """Patches of the wall without points which no element covers: (u, v, square metres)."""
    axes = numpy.array([frame["right"], frame["up"], frame["out"]]).T
    flat = (cloud - numpy.array(frame["origin"])) @ axes
    u0, u1, v0, v1 = box(rings[0])
    near = flat[(flat[:, 2] > -BEHIND) & (flat[:, 2] < BEFORE) & (flat[:, 0] > u0) & (flat[:, 0] < u1) & (flat[:, 1] > v0) &
                (flat[:, 1] < v1)]
    if len(near) < 100:
        return []
    cell = 0.1
    rows, columns = int((v1 - v0) / cell), int((u1 - u0) / cell)
    if rows < 5 or columns < 5:
        return []
    bare = numpy.ones((rows, columns), bool)
    r = numpy.clip(((near[:, 1] - v0) / cell).astype(int), 0, rows - 1)
    c = numpy.clip(((near[:, 0] - u0) / cell).astype(int), 0, columns - 1)
    bare[r, c] = False
    u, v = numpy.meshgrid(u0 + (numpy.arange(columns) + 0.5) * cell, v0 + (numpy.arange(rows) + 0.5) * cell)
    bare &= contains(rings[0], u, v)
    bare = opened(bare, round(SIDE / cell))
    for ring in rings[1:]:
        bare &= ~contains(ring, u, v)
    left, found = opened(bare, round(SIDE / cell)), []
    for part in patches(left):
        low, high = numpy.min(part, 0), numpy.max(part, 0)
        around = [slice(max(0, a - ABOUT), b + ABOUT + 1) for a, b in zip(low, high)]
        here = ((r >= around[0].start) & (r < around[0].stop) & (c >= around[1].start) & (c < around[1].stop)).sum()
        wall = left[around[0], around[1]].size - left[around[0], around[1]].sum()
        if here * SIDE * SIDE >= EXPECTED * wall * cell * cell:
            found.append((u0 + part[0][1] * cell, v0 + part[0][0] * cell, len(part) * cell * cell))
    return found


def texts_of(svg):
    """(layer, text) of each text of the sheet."""
    layer, found = "", []
    for line in svg.read_text().splitlines():
        named = re.search(r'data-layer="([^"]*)"', line)
        layer = named.group(1) if named else layer
        found += [(layer, words) for words in re.findall(r"<text [^>]*>([^<]*)</text>", line)]
    return found


def has_notch(outline, foot):
    """Whether a corner of the top lies below others on both sides."""
    def higher(q, way):
        return any(way * (p[0] - q[0]) > 0.05 and p[1] > q[1] + 0.3 for p in outline)
    return any(q[1] > foot + 0.3 and higher(q, 1) and higher(q, -1) for q in outline)


def judge_elements(elements, note):
    """Returns the rings of what is wall."""
    outline = elements[0][1]
    u0, u1, v0, v1 = box(outline)
    walls = [outline]
    for e, ring in elements[1:]:
        b = box(ring)
        if e.get("region") == "irregularity":
            continue
        if e["kind"] in WALLS_ABOVE and (b[2] >= v1 - 0.1 or b[3] <= v0 + 0.1):
            walls.append(ring)
        past = max(u0 - b[0], b[1] - u1)
        unseen = e["status"] == "occluded"
        if past > PAST:
            note("beyond the wall, " + ("hatched" if unseen else "drawn"), f"{e['id']} {e['kind']} {past:.2f}")
        over = e["opening"] and not unseen and (b[2] + b[3]) / 2 < v1
        if over and max(distance_outside(outline, p) for p in ring) > PAST:
            note("opening over the outline", f"{e['id']}")
    if has_notch(outline, v0):
        note("notch")
    return walls


def judge_texts(svg, walls, height, note):
    texts = texts_of(svg)
    levels = collections.Counter(t for r, t in texts if "LEVEL" in r)
    for t, n in levels.items():
        if n > 1:
            note("level twice", t)
    heights = [float(t.replace(",", ".")) for t in levels]
    for ring in walls[1:]:
        top = height + box(ring)[3]
        if min([abs(h - top) for h in heights], default=1) > 0.03:
            note("no level", f"{top:.2f}")
    sizes = [float(t.replace(",", ".")) for r, t in texts if "DIM" in r and re.fullmatch(r"[\d.,]+", t)]
    boxes = [box(w) for w in walls]
    for size in (max(b[1] for b in boxes) - min(b[0] for b in boxes), max(b[3] for b in boxes) - min(b[2] for b in boxes)):
        if sizes and min(abs(s - size) for s in sizes) > 0.011:
            note("wrong overall size", f"{size:.2f}")


def judge_openings(elements, frame, truth, note):
    u0, u1, _, v1 = box(elements[0][1])
    true = []
    for o in truth["openings"]:
        ring = [in_axes(frame, p) for p in o["ring"]]
        b = box(ring)
        if max(abs(p[2]) for p in ring) < 0.6 and b[0] < u1 and b[1] > u0 and b[2] < v1:
            true.append(b)
    drawn = [box(r) for e, r in elements if e["opening"] and e["status"] != "occluded"]
    for kind, own, other in (("opening missing", true, drawn), ("opening in vain", drawn, true)):
        for b in own:
            if max([overlap(b, d) for d in other], default=0) < 0.5:
                note(kind, " ".join(f"{x:.2f}" for x in b))


def judge(result, cloud, truth, counts, listed):
    for path in sorted((result / "facades").glob("facade-*.json")):
        facade = json.loads(path.read_text())
        frame = facade["frame"]
        elements = [(e, [in_axes(frame, p) for p in e["ring"]]) for e in facade["elements"] if e.get("ring")]
        if not elements or elements[0][0]["kind"] != "outline":
            continue

        def note(kind, what=""):
            counts[kind] += 1
            listed.append(f"{result} {path.stem}: {kind} {what}")

        counts["plans"] += 1
        walls = judge_elements(elements, note)
        judge_texts(path.with_suffix(".svg"), walls, frame["origin"][2], note)
        if cloud is not None:
            rings = [r for e, r in elements if e.get("region") != "irregularity"]
            for u, v, size in bare_places(frame, rings, cloud):
                note("bare drawn as wall", f"at {u:.1f} {v:.1f}: {size:.2f} m2")
                counts["bare drawn as wall, m2"] += size
        if truth is not None:
            judge_openings(elements, frame, truth, note)


def main():
    parser = argparse.ArgumentParser(prog="bench/wild/plan_corrections.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+", type=pathlib.Path)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    runs = []
    for path in options.paths:
        if path.suffix == ".json":
            runs[-1][2] = json.loads(path.read_text())
        elif path.suffix in (".csv", ".npy"):
            runs[-1][1] = numpy.load(path) if path.suffix == ".npy" else numpy.loadtxt(path, delimiter=",", skiprows=1, usecols=(0, 1, 2))
        else:
            runs.append([path, None, None])
    counts, listed = collections.Counter(), []
    for result, cloud, truth in runs:
        judge(result, cloud, truth, counts, listed)
    for kind in sorted(counts):
        print(f"{kind}: {counts[kind]:.1f}" if isinstance(counts[kind], float) else f"{kind}: {counts[kind]}")
    if options.list:
        print("\n".join(listed))


if __name__ == "__main__":
    main()
