#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Says why openings of wild facades are lost and what is drawn in vain: one cause for each lost opening and each drawn one
without a partner, over seeds.

  bench/wild/lost_openings.py PROGRAM FOLDER [--seeds 0-11] [--scene facade-wild] [--points 150000] [--jobs 2]
                              [--scan scene.KEY=VALUE]... [--set facades.KEY=VALUE]... [--calm] [--without FAMILIES]
                              [--list] [--again] [--tag NAME]

Stations are given to the run (scene.station_knowledge=known). --calm begins with the calm values of facade_failures.py.
Clouds stay in FOLDER and are used again. Boxes in the plane of the true opening are compared; found is an intersection over
union of half, as for `ilot evaluate`. A ray comes from the recorded station of its point, or else from the nearest one."""
import argparse
import collections
import concurrent.futures
import csv
import hashlib
import json
import math
import pathlib
import struct
import subprocess

import facade_failures

NEAR = 0.3  # metres between the plane of an opening and what may be drawn of it


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


class Frame:
    """The axes of a wall: right, up, out of it towards the stations."""

    def __init__(self, ring, stations):
        total = [0, 0, 0]
        for a, b in zip(ring[1:], ring[2:]):
            total = [t + c for t, c in zip(total, cross(minus(a, ring[0]), minus(b, ring[0])))]
        self.origin, self.out = ring[0], unit(total)
        if sum(dot(minus(s, ring[0]), self.out) > 0 for s in stations) * 2 < len(stations):
            self.out = [-x for x in self.out]
        self.right = unit(cross([0, 0, 1], self.out))
        self.up = cross(self.out, self.right)

    def flat(self, p):
        d = minus(p, self.origin)
        return dot(d, self.right), dot(d, self.up), dot(d, self.out)

    def box(self, ring):
        flat = [self.flat(p) for p in ring]
        return tuple(f(p[k] for p in flat) for k in (0, 1, 2) for f in (min, max))


def area(b):
    return max(0, b[1] - b[0]) * max(0, b[3] - b[2])


def common(a, b):
    return area((max(a[0], b[0]), min(a[1], b[1]), max(a[2], b[2]), min(a[3], b[3])))


def iou(a, b):
    both = common(a, b)
    return both / (area(a) + area(b) - both) if both else 0


def points_of(path):
    """Coordinates and station numbers of a LAS file."""
    data = path.read_bytes()
    offset, kind, size = struct.unpack_from("<I", data, 96)[0], data[104] & 63, struct.unpack_from("<H", data, 105)[0]
    count = struct.unpack_from("<Q", data, 247)[0] if data[25] >= 4 else struct.unpack_from("<I", data, 107)[0]
    scale, shift = struct.unpack_from("<3d", data, 131), struct.unpack_from("<3d", data, 155)
    source = 20 if kind >= 6 else 18
    record = struct.Struct(f"<3i{source - 12}xH{size - source - 2}x")
    for x, y, z, s in record.iter_unpack(data[offset:offset + count * size]):
        yield (x * scale[0] + shift[0], y * scale[1] + shift[1], z * scale[2] + shift[2]), s


def rays_of(frame, box, points, stations):
    """Rays through a box on the wall: stopped before it, ended near its plane, ended behind; and points on the wall around."""
    before = near = behind = around = 0
    wide = (box[0] - 0.4, box[1] + 0.4, box[2] - 0.4, box[3] + 0.4)
    middle = ((box[0] + box[1]) / 2, (box[2] + box[3]) / 2)
    flat_stations = {k: frame.flat(s) for k, s in stations.items()}
    for p, source in points:
        u, v, w = frame.flat(p)
        if max(abs(u - middle[0]), abs(v - middle[1]), abs(w)) > 60:
            continue
        s = flat_stations.get(source) or min(flat_stations.values(), key=lambda s: math.dist(s, (u, v, w)), default=(u, v, 1e6))
        if s[2] < 0.5 or w > s[2] - 0.1:
            continue
        t = s[2] / (s[2] - w)
        cu, cv = s[0] + t * (u - s[0]), s[1] + t * (v - s[1])
        if not (wide[0] <= cu <= wide[1] and wide[2] <= cv <= wide[3]):
            continue
        if box[0] <= cu <= box[1] and box[2] <= cv <= box[3]:
            if w > 0.25:
                before += 1
            elif w > -0.4:
                near += 1
            else:
                behind += 1
        elif abs(w) < 0.1:
            around += 1
    ring = area(wide) - area(box)
    return dict(before=before, near=near, behind=behind, expected=around / ring * area(box) if ring else 0)


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
    number = opening["element"] - 1
    depth = truth["elements"][number].get("depth_m") if number < len(truth["elements"]) else None
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
    points = list(points_of(cloud)) if len(taken) < len(boxes) else []
    rows = []
    for t, (frame, box, o) in enumerate(zip(frames, boxes, truth["openings"])):
        if t in taken:
            rows.append(dict(what="true", opening=o["id"], facade=o["facade"], cause="found", detail=drawn[taken[t]][0], tags=""))
            continue
        rays = rays_of(frame, box, points, stations)
        cause, detail = cause_of_loss(frame, box, facades, rays)
        rows.append(dict(what="true", opening=o["id"], facade=o["facade"], cause=cause, detail=detail + " " + " ".join(
            f"{k} {v:.0f}" for k, v in rays.items()), tags=" ".join(tags_of(frame, box, o, truth, rays))))
    for d, (name, e) in enumerate(drawn):
        if d in used:
            continue
        near = [t for t, f in enumerate(frames) if abs(f.flat(e["ring"][0])[2]) < 0.6]
        frame = frames[near[0]] if near else Frame(e["ring"], places)
        cause = cause_in_vain(frame, frame.box(e["ring"]), truth, [(frame.box(truth["openings"][t]["ring"]), t) for t in near])
        b = frame.box(e["ring"])
        rows.append(dict(what="drawn", opening=e["id"], facade=name, cause=cause,
                         detail=f"{e['kind']} {b[1] - b[0]:.2f} x {b[3] - b[2]:.2f} {e.get('reason', '')}", tags=""))
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
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for seed, rows, folder in pool.map(lambda seed: judge(given, seed), range(int(first), int(last or first) + 1)):
            if rows is None:
                print(f"seed {seed}: the run failed")
                continue
            true = [r for r in rows if r["what"] == "true"]
            found, sheets = sum(r["cause"] == "found" for r in true), collections.defaultdict(set)
            for r in true:
                if r["cause"] == "found":
                    sheets[r["detail"]].add(r["facade"])
            several = sum(len(s) > 1 for s in sheets.values())
            print(f"seed {seed}: {found} of {len(true)} found, {len(rows) - len(true)} in vain, {several} sheets with several houses  {folder}")
            for r in rows:
                (lost if r["what"] == "true" else vain)[r["cause"]] += 1
                for tag in r["tags"].split():
                    tags[r["cause"]][tag] += 1
                if given.list and r["cause"] != "found":
                    print("   ", *r.values())
    total = sum(lost.values())
    print(f"openings: {lost['found']} of {total} found, {sum(vain.values())} drawn in vain")
    for name, counts in (("true openings", lost), ("drawn in vain", vain)):
        print(name)
        for cause, n in counts.most_common():
            print(f"  {n:4d}  {cause}  {', '.join(f'{k} {v}' for k, v in tags[cause].most_common(6))}")


if __name__ == "__main__":
    main()
