#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the stated errors of drawn edges of openings with the truth, edge by edge, over wild scenes: the share of
edges within their stated error, over all and by fifths of noise, registration, density, incidence and stated error.

  bench/wild/edge_errors.py PROGRAM FOLDER [--seeds 0-19] [--scenes facade-wild,row-wild,court-wild] [--jobs 2]
                            [--set facades.regularise=false]... [--tag NAME] [--scan scene.shutters=1]... [--as-drawn]

Stations are given to the run; with --as-drawn only where the scene has drawn that they are known. Scans stay in FOLDER
and are used again; results are in FOLDER/TAG.csv. The true error of an edge is the distance of the side of its box from that of the true box, in the axes of the drawn facade. Edges that are
occluded are not judged, nor openings under arcs, nor those without a partner (intersection over union of half)."""
import argparse
import concurrent.futures
import csv
import json
import math
import pathlib
import statistics
import subprocess
import sys

import commands

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from facade_frame import dot, in_axes, overlap  # noqa: E402

POINTS = {"facade-wild": 200000, "row-wild": 300000, "court-wild": 300000}
SIDES = ("bottom", "right", "top", "left")


def box(places):
    us, vs = [p[0] for p in places], [p[1] for p in places]
    return min(us), max(us), min(vs), max(vs)


def rows_of(out, truth):
    """One row for each drawn edge of a matched opening."""
    drawn = {d["name"]: d.get("choice", d["value"]) for d in truth.get("drawn", [])}
    stations = [s.get("position", s.get("place")) for s in truth["stations"]]
    rows, matched, found = [], set(), 0
    for path in sorted((out / "facades").glob("facade-*.json")):
        facade = json.loads(path.read_text())
        f = facade["frame"]
        flat = lambda p: in_axes(f, p)
        true = []
        for k, o in enumerate(truth["openings"]):
            ring = [flat(p) for p in o["ring"]]
            if max(abs(p[2]) for p in ring) < 0.3:
                true.append((k, box(ring), len(ring)))
        for e in facade["elements"]:
            if not e["opening"] or e["status"] == "occluded":
                continue
            found += 1
            own = box([flat(p) for p in e["ring"]])
            best = max(true, key=lambda t: overlap(own, t[1]), default=None)
            if best is None or overlap(own, best[1]) < 0.5 or best[0] in matched:
                continue
            matched.add(best[0])
            if len(e["ring"]) != 4 or best[2] != 4:
                continue
            centre = [(own[0] + own[1]) / 2, (own[2] + own[3]) / 2, 0]
            angles = [math.degrees(math.acos(max(-1, min(1, d[2] / math.sqrt(dot(d, d))))))
                      for d in ([a - b for a, b in zip(flat(s), centre)] for s in stations)]
            places = dict(bottom=2, right=1, top=3, left=0)
            for side, edge in zip(SIDES, e["edges"]):
                if edge["status"] == "occluded":
                    continue
                off = own[places[side]] - best[1][places[side]]
                rows.append(dict(status=edge["status"], side=side, stated=edge["error_m"], off=off, moved=edge["moved_m"],
                                 noise=drawn.get("range_noise", 0), registration=drawn.get("registration_shift", 0),
                                 density=truth["density"], incidence=min(angles, default=0), element=e["id"],
                                 facade=path.stem, u=own[0], v=own[2], at=own[places[side]]))
    return rows, len(matched), found, len(truth["openings"])


def judge(given, scene, seed):
    changed = "".join("-" + s.replace("scene.", "").replace("=", "_") for s in given.scan)
    changed += "-as-drawn" if given.as_drawn else ""
    cloud = given.folder / f"{scene}-{seed}{changed}.las"
    truth_file = cloud.with_suffix(".truth.json")
    if not truth_file.exists():
        known = [] if given.as_drawn else ["station_knowledge=known"]
        settings = [*known, *(s.removeprefix("scene.") for s in given.scan)]
        words = [*commands.scan(given.program, scene, seed, cloud, settings), "--points", str(POINTS[scene]), "-q"]
        if subprocess.run(words, capture_output=True).returncode:
            return scene, seed, None
    out = given.folder / f"out-{given.tag}-{scene}-{seed}{changed}"
    words = [*commands.run(given.program, cloud, out, "facades"), "-q", "--no-clouds"]
    words += [word for s in given.set for word in ("--set", s)]
    run = subprocess.run(words, capture_output=True, text=True)
    if run.returncode:
        return scene, seed, None
    truth = json.loads(truth_file.read_text())
    truth["density"] = 0
    for d in truth.get("drawn", []):
        if d["name"] == "density":
            truth["density"] = d["value"]
    return scene, seed, rows_of(out, truth)


def share(rows):
    return sum(abs(float(r["off"])) <= float(r["stated"]) for r in rows) / len(rows) if rows else 0


def median(values):
    return statistics.median_high(values) if values else 0


def sheet_line(rows):
    """The error within which 95 of 100 of these edges are expected, as the sheet has it for all of its elements."""
    stated = [float(r["stated"]) for r in rows]
    low, high = min(stated), max(stated)
    for _ in range(40):
        middle = (low + high) / 2
        expected = sum(math.erf(1.959964 * middle / (error * math.sqrt(2))) for error in stated if error) / len(stated)
        low, high = (middle, high) if expected < 0.95 else (low, middle)
    return high


def line(name, rows):
    stated, true = median([float(r["stated"]) for r in rows]), median([abs(float(r["off"])) for r in rows])
    mean = sum(abs(float(r["off"])) for r in rows) / len(rows) if rows else 0
    print(f"{name:34s} {len(rows):6d} edges  within {100 * share(rows):5.1f} %  median stated {1000 * stated:6.1f}"
          f"  true {1000 * true:6.1f} mm  mean true {1000 * mean:6.1f}")


def report(rows):
    line("all", rows)
    for status in ("seen", "completed"):
        line(status, [r for r in rows if r["status"] == status])
    seen = [r for r in rows if r["status"] == "seen"]
    for side in SIDES:
        line("seen, " + side, [r for r in seen if r["side"] == side])
    for key in ("noise", "registration", "density", "incidence", "stated"):
        order = sorted(rows, key=lambda r: float(r[key]))
        for k in range(5):
            part = order[k * len(order) // 5:(k + 1) * len(order) // 5]
            if part:
                line(f"{key} {float(part[0][key]):.4g} to {float(part[-1][key]):.4g}", part)
    sheets = {}
    for r in seen:
        sheets.setdefault((r["scene"], r["seed"], r["facade"]), []).append(r)
    within = sum(sum(abs(float(r["off"])) <= sheet_line(part) for r in part) for part in sheets.values())
    print(f"seen edges within the line of their sheet: {100 * within / max(1, len(seen)):.1f} % of {len(seen)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seeds", type=commands.range_of, default=(0, 19))
    parser.add_argument("--scenes", default="facade-wild,row-wild,court-wild")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--scan", action="append", default=[])
    parser.add_argument("--tag", default="a")
    parser.add_argument("--as-drawn", action="store_true")
    given = parser.parse_args()
    first, last = given.seeds
    given.folder.mkdir(parents=True, exist_ok=True)
    todo = [(scene, seed) for seed in range(first, last + 1) for scene in given.scenes.split(",")]
    rows, matched, found, true, failed = [], 0, 0, 0, []
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for scene, seed, result in pool.map(lambda item: judge(given, *item), todo):
            if result is None:
                failed.append(f"{scene} {seed}")
                continue
            for row in result[0]:
                rows.append(dict(scene=scene, seed=seed, **row))
            matched, found, true = matched + result[1], found + result[2], true + result[3]
    with (given.folder / f"{given.tag}.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]) if rows else ["scene"])
        writer.writeheader()
        writer.writerows(rows)
    print(f"openings: {matched} of {true} found, {found - matched} of {found} drawn in vain"
          + (f"; failed: {', '.join(failed)}" if failed else ""))
    report(rows)


if __name__ == "__main__":
    main()
