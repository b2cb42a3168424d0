#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Says why openings of wild facades are lost and what is drawn in vain: one cause for each lost opening and each drawn one
without a partner, over seeds.

  bench/wild/lost_openings.py PROGRAM FOLDER [--seeds 0-11] [--scene facade-wild] [--points 150000] [--jobs 2]
                              [--scan scene.KEY=VALUE]... [--set facades.KEY=VALUE]... [--calm] [--without FAMILIES]
                              [--list] [--again] [--tag NAME]

Stations are given to the run (scene.station_knowledge=known). --calm begins with the calm values of facade_failures.py.
Clouds stay in FOLDER and are used again. Boxes in the plane of the true opening are compared; found is an intersection over
union of half, as for `ilot evaluate`. A ray comes from the recorded station of its point, or else from the nearest one.
Needs numpy.

Each line of the table of causes begins with two numbers: all true openings, and those that at least 50 rays met or went
through (--least-rays). These are the points on and behind its area; where the wall about the opening shows that more rays
came this way than ended there or before it, these count as rays without an echo.

The last table counts the windows with shutters by the state of their leaves (closed: before the wall; inset: closed within the
reveal; open; half): all, those with so many rays, those found, those of which leaves are drawn, and those with both. Leaves are
drawn where elements of the kind shutter cover half of their area, or stand at the hinge of a half open one. What is drawn as a
shutter where no leaf is comes below it."""
import argparse
import collections
import concurrent.futures
import csv
import hashlib
import json
import pathlib
import struct
import subprocess

import numpy

import facade_failures
from wall_frame import Frame, area, common, dot, iou
from window_leaves import are_drawn, leaves_of, shutter_cause

NEAR = 0.3  # metres between the plane of an opening and what may be drawn of it


def points_of(path):
    """Coordinates and station numbers of a LAS file, as two arrays."""
    data = path.read_bytes()
    offset, kind, size = struct.unpack_from("<I", data, 96)[0], data[104] & 63, struct.unpack_from("<H", data, 105)[0]
    count = struct.unpack_from("<Q", data, 247)[0] if data[25] >= 4 else struct.unpack_from("<I", data, 107)[0]
    scale, shift = struct.unpack_from("<3d", data, 131), struct.unpack_from("<3d", data, 155)
    source = 20 if kind >= 6 else 18
    record = numpy.dtype({"names": ["at", "source"], "formats": ["<3i4", "<u2"], "offsets": [0, source], "itemsize": size})
    rows = numpy.frombuffer(data, record, count, offset)
    return rows["at"] * numpy.array(scale) + numpy.array(shift), rows["source"]


def stations_of(places, sources, stations):
    """The place of the station of each point: the recorded one, or the nearest one."""
    at = numpy.array(list(stations.values()), float).reshape(-1, 3)
    nearest = numpy.argmin([((places - s) ** 2).sum(1) for s in at], axis=0)
    for k, name in enumerate(stations):
        nearest[sources == name] = k
    return at[nearest]


def rays_of(frame, box, places, eyes):
    """Rays through a box on the wall: stopped before it, ended near its plane, ended behind; and points on the wall around.
    `reached` are those that met the opening or went through it."""
    axes = numpy.array([frame.right, frame.up, frame.out]).T
    flat, seen_from = (places - frame.origin) @ axes, (eyes - frame.origin) @ axes
    wide = (box[0] - 0.4, box[1] + 0.4, box[2] - 0.4, box[3] + 0.4)
    middle = numpy.array([(box[0] + box[1]) / 2, (box[2] + box[3]) / 2, 0])
    w = flat[:, 2]
    used = (numpy.abs(flat - middle).max(1) <= 60) & (seen_from[:, 2] >= 0.5) & (w <= seen_from[:, 2] - 0.1)
    flat, seen_from = flat[used], seen_from[used]
    w = flat[:, 2]
    at = seen_from[:, :2] + (seen_from[:, 2] / (seen_from[:, 2] - w))[:, None] * (flat - seen_from)[:, :2]

    def within(b):
        return (at[:, 0] >= b[0]) & (at[:, 0] <= b[1]) & (at[:, 1] >= b[2]) & (at[:, 1] <= b[3])

    inside, about = within(box), within(wide)
    before, near = int((inside & (w > 0.25)).sum()), int((inside & (w <= 0.25) & (w > -0.4)).sum())
    behind, ring = int(inside.sum()) - before - near, area(wide) - area(box)
    around = int((about & ~inside & (numpy.abs(w) < 0.1)).sum())
    expected = around / ring * area(box) if ring else 0
    return dict(before=before, near=near, behind=behind, expected=expected, reached=max(near + behind, expected - before))


def facades_of(out):
    facades = []
    for path in sorted((out / "facades").glob("facade-*.json")):
        facade = json.loads(path.read_text())
        facade["name"] = path.stem
        facades.append(facade)
    return facades


def cause_of_loss(frame, box, facades, rays):
    here, mirrored = [], False
    for f in facades:
        g = f["frame"]
        if abs(dot(g["out"], frame.out)) < 0.98:
            continue
        wall = next((frame.box(e["ring"]) for e in f["elements"] if e.get("ring")), None)
        if wall is None or max(abs(wall[4]), abs(wall[5])) > 5 or common(wall, box) < 0.5 * area(box):
            continue
        away = (wall[4] + wall[5]) / 2
        if abs(away) < 0.6:
            here.append((abs(away), f))
            if abs(away) < NEAR and dot(g["out"], frame.out) < 0:
                mirrored = True
    if not here:
        return "no facade there", ""
    hidden = rays["before"] > 2 * (rays["near"] + rays["behind"]) and rays["before"] > 0.5 * rays["expected"]
    if mirrored:
        return "facade is mirrored", ""
    if rays["expected"] < 12:
        return "fewer than 12 rays", ""
    if hidden:
        return "hidden", ""
    elements = [(frame.box(e["ring"]), e, f["name"]) for _, f in here for e in f["elements"][1:] if e.get("ring")]
    open_ones = [(b, e) for b, e, _ in elements if e["opening"] and e["status"] != "occluded" and max(abs(b[4]), abs(b[5])) < 0.6]
    inside = [b for b, e in open_ones if common(b, box) > 0.6 * area(b)]
    if min(a for a, _ in here) > NEAR:
        return "on a sheet of another plane", f"{min(a for a, _ in here):.2f} m"
    if len(inside) > 1:
        return "drawn as pieces", f"{len(inside)} pieces"
    if inside:
        b = inside[0]
        return "drawn too small", f"{iou(b, box):.2f} off l {b[0]-box[0]:.2f} r {b[1]-box[1]:.2f} b {b[2]-box[2]:.2f} t {b[3]-box[3]:.2f}"
    larger = [b for b, e in open_ones if common(b, box) > 0.6 * area(box)]
    if larger:
        b = larger[0]
        return "drawn too large", f"{iou(b, box):.2f} off l {b[0]-box[0]:.2f} r {b[1]-box[1]:.2f} b {b[2]-box[2]:.2f} t {b[3]-box[3]:.2f}"
    others = sorted(((common(b, box), iou(b, box), e["kind"], e["status"]) for b, e, _ in elements), reverse=True)
    if others and others[0][0] > 0.5 * area(box):
        kind = others[0][2]
        if others[0][3] == "occluded":
            return f"drawn as {kind}", ""
        return f"drawn as {kind}", f"{others[0][1]:.2f}"
    if others and others[0][0] > 0.25 * area(box):
        return "in part drawn as something else", f"{others[0][2]} {others[0][1]:.2f}"
    return "nothing drawn", ""


def cause_in_vain(frame, box, truth, boxes):
    """What a drawn opening without a partner lies on."""
    for b, o in boxes:
        if common(b, box) > 0.6 * area(box):
            return "piece of a true opening"
    for b, o in boxes:
        if common(b, box) > 0.6 * area(b):
            return "larger than a true opening"
    for b, o in boxes:
        if common(b, box) > 0.3 * area(box):
            return "beside a true opening"
    best = max(((common(frame.box(e["ring"]), box) / area(box), e["kind"]) for e in truth["elements"]
                if e.get("ring") and len(e["ring"]) > 2 and abs(frame.box(e["ring"])[4]) < 2.5), default=(0, ""))
    return f"on {best[1]}" if best[0] > 0.3 else "elsewhere"


def tags_of(frame, box, opening, truth, rays):
    tags = []
    if len(opening["ring"]) > 4:
        tags.append("arch")
    depth = next((e.get("depth_m") for e in truth["elements"] if e["id"] == opening["element"]), None)
    if depth is not None and abs(depth) < 0.06:
        tags.append("flush")
    if rays["near"] + rays["behind"] < 0.3 * rays["expected"]:
        tags.append("few echoes")
    grown = (box[0] - 0.1, box[1] + 0.1, box[2], box[3])
    kinds = set()
    for e in truth["elements"]:
        if not e.get("ring") or e["kind"] in ("window", "door", "opening", "sill"):
            continue
        b = frame.box(e["ring"])
        if max(abs(b[4]), abs(b[5])) < 2.5 and (common(b, grown) > 0.15 * area(box) or
                                                   e["kind"] in ("shutter",) and common(b, grown) > 0.05 * area(box)):
            kinds.add(e["kind"])
    return tags + sorted(kinds)


def judge(given, seed):
    words = given.scan_words(seed)
    cloud = given.folder / (hashlib.sha256(" ".join([given.scene, *words]).encode()).hexdigest()[:10] + f"-{seed}") / "a.las"
    truth_file, stations = cloud.with_suffix(".truth.json"), cloud.with_suffix(".stations.csv")
    if not truth_file.exists():
        cloud.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([given.program, "scan", given.scene, "-o", str(cloud), *words], check=True, capture_output=True)
    out = cloud.parent / f"out-{given.tag}"
    words = [given.program, "run", str(cloud), "-o", str(out), "--overwrite", "-q", "--products", "facades", "--threads",
             "1", "--no-clouds"]
    for s in given.set:
        words += ["--set", s]
    if stations.exists():
        words += ["--stations", str(stations)]
    if not (given.again and (out / "facades").exists()) and subprocess.run(words, capture_output=True).returncode:
        return seed, None, cloud.parent
    return seed, losses_of(json.loads(truth_file.read_text()), facades_of(out), cloud), cloud.parent


def losses_of(truth, facades, cloud):
    places = [s["position"] for s in truth["stations"]]
    stations = {s["id"]: s["position"] for s in truth["stations"]}
    drawn = [(f["name"], e) for f in facades for e in f["elements"] if e["opening"] and e["status"] != "occluded"]
    frames = [Frame(o["ring"], places) for o in truth["openings"]]
    boxes = [f.box(o["ring"]) for f, o in zip(frames, truth["openings"])]
    pairs = []
    for t, (frame, box) in enumerate(zip(frames, boxes)):
        for d, (_, e) in enumerate(drawn):
            own = frame.box(e["ring"])
            if abs(frame.flat(e["ring"][0])[2]) <= NEAR and iou(own, box) >= 0.5:
                pairs.append((-iou(own, box), t, d))
    taken, used = {}, {}
    for _, t, d in sorted(pairs):
        if t not in taken and d not in used:
            taken[t], used[d] = d, t
    points, sources = points_of(cloud)
    eyes = stations_of(points, sources, stations)
    rows = []
    for t, (frame, box, o) in enumerate(zip(frames, boxes, truth["openings"])):
        rays = rays_of(frame, box, points, eyes)
        reached = rays["reached"]
        state, leaves = leaves_of(frame, box, o, truth)
        if state:
            rows.append(dict(what="leaves", opening=o["id"], facade=o["facade"], cause="found" if t in taken else "lost",
                             detail=state, tags="drawn" if are_drawn(frame, leaves, state, facades) else "", rays=reached))
        if t in taken:
            rows.append(dict(what="true", opening=o["id"], facade=o["facade"], cause="found", detail=drawn[taken[t]][0], tags="",
                             rays=reached))
            continue
        cause, detail = cause_of_loss(frame, box, facades, rays)
        rows.append(dict(what="true", opening=o["id"], facade=o["facade"], cause=cause, detail=detail + " " + " ".join(
            f"{k} {v:.0f}" for k, v in rays.items()), tags=" ".join(tags_of(frame, box, o, truth, rays)), rays=reached))
    for f in facades:
        for e in f["elements"]:
            if e["kind"] == "shutter":
                rows.append(dict(what="shutter", opening=e["id"], facade=f["name"], cause=shutter_cause(e, frames, boxes, truth),
                                 detail=e["reason"], tags=f"{e['width_m']:.2f} x {e['height_m']:.2f} x {e['depth_m']:.2f}", rays=0))
    for d, (name, e) in enumerate(drawn):
        if d in used:
            continue
        near = [t for t, f in enumerate(frames) if abs(f.flat(e["ring"][0])[2]) < 0.6]
        frame = frames[near[0]] if near else Frame(e["ring"], places)
        cause = cause_in_vain(frame, frame.box(e["ring"]), truth, [(frame.box(truth["openings"][t]["ring"]), t) for t in near])
        b = frame.box(e["ring"])
        rows.append(dict(what="drawn", opening=e["id"], facade=name, cause=cause,
                         detail=f"{e['kind']} {b[1] - b[0]:.2f} x {b[3] - b[2]:.2f} {e.get('reason', '')}", tags="", rays=0))
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seeds", default="0-11")
    parser.add_argument("--scene", default="facade-wild")
    parser.add_argument("--points", default="150000")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--scan", action="append", default=[])
    parser.add_argument("--without", default="")
    parser.add_argument("--calm", action="store_true")
    parser.add_argument("--list", action="store_true", help="each opening")
    parser.add_argument("--again", action="store_true", help="judge the results that are there")
    parser.add_argument("--tag", default="a")
    parser.add_argument("--least-rays", type=float, default=50)
    given = parser.parse_args()

    def scan_words(seed):
        words = ["--seed", str(seed), "--points", given.points, "--overwrite", "-q", "--threads", "1"]
        values, without = {"station_knowledge": "known"}, given.without
        if given.calm:
            calm = {**facade_failures.CALM, **(facade_failures.ROW if given.scene == "row-wild" else {})}
            values, without = {k: v for k, v in calm.items() if v is not None}, facade_failures.FAMILIES + (
                ",neighbours" if given.scene == "facade-wild" else "")
        values.update(s.removeprefix("scene.").split("=") for s in given.scan)
        for key, value in values.items():
            if value != "drawn":
                words += ["--set", f"scene.{key}={value}"]
        return words + (["--without", without] if without else [])

    given.scan_words = scan_words
    first, _, last = given.seeds.partition("-")
    given.folder.mkdir(parents=True, exist_ok=True)
    lost, vain, tags = collections.Counter(), collections.Counter(), collections.defaultdict(collections.Counter)
    shutters = collections.Counter()
    reached, states = collections.Counter(), collections.defaultdict(lambda: numpy.zeros(5, int))
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for seed, rows, folder in pool.map(lambda seed: judge(given, seed), range(int(first), int(last or first) + 1)):
            if rows is None:
                print(f"seed {seed}: the run failed")
                continue
            for r in (r for r in rows if r["what"] == "leaves"):
                found, drawn = r["cause"] == "found", r["tags"] == "drawn"
                states[r["detail"]] += numpy.array([1, r["rays"] >= given.least_rays, found, drawn, found and drawn])
            shutters.update((r["cause"], r["detail"]) for r in rows if r["what"] == "shutter")
            if given.list:
                for r in rows:
                    if r["what"] == "shutter" and r["cause"] != "a leaf":
                        print("   ", seed, *r.values())
            rows = [r for r in rows if r["what"] not in ("leaves", "shutter")]
            true = [r for r in rows if r["what"] == "true"]
            found, sheets = sum(r["cause"] == "found" for r in true), collections.defaultdict(set)
            for r in true:
                if r["cause"] == "found":
                    sheets[r["detail"]].add(r["facade"])
            several = sum(len(s) > 1 for s in sheets.values())
            print(f"seed {seed}: {found} of {len(true)} found, {len(rows) - len(true)} in vain, {several} sheets with several houses  {folder}")
            for r in rows:
                (lost if r["what"] == "true" else vain)[r["cause"]] += 1
                reached[r["cause"]] += r["rays"] >= given.least_rays
                for tag in r["tags"].split():
                    tags[r["cause"]][tag] += 1
                if given.list and r["cause"] != "found":
                    print("   ", *r.values())
    total = sum(lost.values())
    print(f"openings: {lost['found']} of {total} found, {sum(vain.values())} drawn in vain; of those with {given.least_rays:.0f} rays "
          f"{reached['found']} of {sum(reached.values())} found")
    for name, counts in (("true openings: all, with rays", lost), ("drawn in vain", vain)):
        print(name)
        for cause, n in counts.most_common():
            rays = f" {reached[cause]:4d}" if counts is lost else ""
            print(f"  {n:4d}{rays}  {cause}  {', '.join(f'{k} {v}' for k, v in tags[cause].most_common(6))}")
    if states:
        print("windows with leaves: all, with rays, found, leaves drawn, both")
        for state, counts in sorted(states.items()) + [("all", sum(states.values()))]:
            print(f"  {state:7s}", *(f"{n:4d}" for n in counts))
    if shutters:
        print("drawn as shutters")
        for (cause, detail), n in sorted(shutters.items()):
            print(f"  {n:4d}  {cause}: {detail}")


if __name__ == "__main__":
    main()
