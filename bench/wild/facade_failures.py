#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what each drawn parameter does to facades. A calm scene is scanned, drawn and judged for several seeds; then
the same seeds with one parameter at a value that is known to fail. Writes one line of CSV for each scan and prints the
table of bench/wild/history/facades.md.

  bench/wild/facade_failures.py PROGRAM FOLDER [--seeds 0-3] [--jobs 2] [--only "NAME;NAME"]

Finished scans are found in FOLDER/results.csv and not made again."""
import argparse
import concurrent.futures
import csv
import json
import pathlib
import shutil
import subprocess
import threading

import commands

FAMILIES = ("vehicles,cars,people,trees,poles,hedges,cables,arches,stones,mirrors,blinds,shutters,sills,mouldings,"
            "balconies,gutters,signs,awnings,fixtures,plants,scaffolds,chimneys,dormers")
CALM = dict(
    stations=3, station_knowledge="known", station_steps="given", station_distance=12, range_noise=0.002,
    incidence_bias=0, angle_noise=0.001, divergence=0.2, beam_diameter=0.004, separation=0.3, mixed_pixels="kept",
    registration_shift=0, registration_turn=0, returns="all", intensity="present", colour="missing",
    gps_time="present", source_id="present", coordinate_grid="tenth_mm", stray_points=0, dropouts=0, crop_front=3,
    crop_behind=3, crop_beside=0, pavement_width=2, road_width=8, kerb=0.1, street_slope=0, house_width=10, storeys=3,
    ground_storey=3.2, storey_height=3, bay=2.4, window_width=1.1, window_change=1, window_height=0.5, window_sill=0.3,
    scatter=0, own_bays=0, blank_bays=0, reveal=0.2, wall_lean=0, bow_across=0, bow_up=0, roughness=0.0003,
    ground_floor="windows", panes_without_echo=0, panes_clear=0, panes_dusty=0, frames_missing=0, frame_width=0.06, curtains=0.3,
    eaves=0.3, density=500)
ROW = dict(houses=4, setbacks=0, row_bend=0, opposite="none", house_width=8)
SHUT = dict(shutters=1, shutter_state="closed", shutter_depth=0.05, shutter_thickness=0.04)
# name: (scene, families that stay, changes from the calm scene, points)
ARMS = {
    "calm": ("facade-wild", "", {}, 150000),
    "no stations": ("facade-wild", "", dict(station_knowledge="unknown", crop_front=8), 150000),
    "stations without steps": ("facade-wild", "", dict(station_steps="missing"), 150000),
    "windows scatter by 12 mm": ("facade-wild", "", dict(scatter=0.012), 150000),
    "panes without echo": ("facade-wild", "", dict(panes_without_echo=1), 150000),
    "panes and frames without echo": ("facade-wild", "", dict(panes_without_echo=1, frames_missing=1), 150000),
    "no echo, vans, trees, poles before": ("facade-wild", "vehicles,cars,trees,poles", dict(
        panes_without_echo=1, frames_missing=1, cars=3, trees=2, poles=3, stations=2, crop_front=15, density=1000), 900000),
    "the same, street cut off, one station": ("facade-wild", "vehicles,cars,trees,poles", dict(
        panes_without_echo=1, frames_missing=1, cars=3, trees=2, poles=3, stations=1, crop_front=0.5), 150000),
    "vans, trees, poles, no openings": ("facade-wild", "vehicles,cars,trees,poles", dict(
        blank_bays=0.4, cars=4, trees=3, poles=4, stations=1, crop_front=1.5), 150000),
    "shutters half open": ("facade-wild", "shutters", dict(shutters=1, shutter_state="half"), 150000),
    "shutters open": ("facade-wild", "shutters", dict(shutters=1, shutter_state="open"), 150000),
    "shutters closed": ("facade-wild", "shutters", SHUT, 150000),
    "shutters closed, registration 3 mm": ("facade-wild", "shutters", dict(SHUT, registration_shift=0.003), 150000),
    "blinds": ("facade-wild", "blinds", dict(blinds=1, blind_closed=0.5), 150000),
    "reveals of 5 cm": ("facade-wild", "", dict(reveal=0.05), 150000),
    "coarse": ("facade-wild", "", {}, 30000),
    "one station, oblique": ("facade-wild", "", dict(stations=1, station_along=-0.25, station_distance=5), 150000),
    "small windows": ("facade-wild", "", dict(window_width=0.55, bay=1.5, window_height=0.32), 150000),
    "trees": ("facade-wild", "trees", dict(trees=3, stations=2), 150000),
    "pointed arches": ("facade-wild", "arches", dict(arch_form="pointed"), 150000),
    "plants and hedges": ("facade-wild", "plants,hedges", dict(plants=4, hedges=3), 150000),
    "walls lean and bow by 3 cm": ("facade-wild", "", dict(wall_lean=0.03, bow_across=0.03, bow_up=0.03), 150000),
    "joints of 8 mm": ("facade-wild", "stones", dict(wall_kind="ashlar", joint_width=0.008, joint_depth=0.008), 150000),
    "registration 10 mm": ("facade-wild", "", dict(registration_shift=0.01), 150000),
    "row in line": ("row-wild", "", ROW, 300000),
    "row, set back by 5 mm": ("row-wild", "", dict(ROW, setbacks=1, setback=0.005), 300000),
    "row, set back by 5 cm": ("row-wild", "", dict(ROW, setbacks=1, setback=0.05), 300000),
    "row, set back by 2 cm": ("row-wild", "", dict(ROW, setbacks=1, setback=0.02), 300000),
    "street, both sides, no stations": ("row-wild", "", dict(ROW, opposite="houses", station_knowledge="unknown"), 300000),
    "court": ("court-wild", "", dict(court_width=12, court_depth=10, court_turn=0, house_width=None), 300000),
    "court, no stations": ("court-wild", "", dict(court_width=12, court_depth=10, court_turn=0, house_width=None,
                                                  station_knowledge="unknown"), 300000),
    # Everything drawn.
    "facade-wild": ("facade-wild", None, {}, 200000),
    "row-wild": ("row-wild", None, {}, 300000),
    "court-wild": ("court-wild", None, {}, 300000),
}


def scan_words(program, arm, seed, cloud):
    scene, kept, changes, points = ARMS[arm]
    settings, without = [], []
    if kept is not None:
        settings = [f"{key}={value}" for key, value in {**CALM, **changes}.items() if value is not None]
        without = [f for f in FAMILIES.split(",") if f not in kept.split(",")]
        without += ["neighbours"] if scene == "facade-wild" else []
    return [*commands.scan(program, scene, seed, cloud, settings, ",".join(without)), "--points", str(points), "-q"]


def judge(program, folder, arm, seed):
    work = folder / f"{list(ARMS).index(arm)}-{seed}"
    work.mkdir(parents=True, exist_ok=True)
    cloud, out = work / "a.las", work / "out"
    subprocess.run(scan_words(program, arm, seed, cloud), check=True, capture_output=True)
    run = subprocess.run([*commands.run(program, cloud, out, "facades"), "-q", "--no-clouds"], capture_output=True, text=True)
    truth = json.loads((work / "a.truth.json").read_text())
    message = (run.stderr.strip().splitlines() or [""])[-1][:120]
    row = dict(arm=arm, seed=seed, exit=run.returncode, true=len(truth["openings"]), found="", matched="", iou="",
               distance="", jambs="", mirrored="", facades="", message=message)
    if run.returncode == 0:
        said = subprocess.run(commands.evaluate(program, out, cloud), capture_output=True, text=True)
        report = json.loads(said.stdout)
        openings, sides = report.get("openings") or {}, report.get("facades") or {}
        row.update(found=openings.get("found", ""), matched=openings.get("matched", ""),
                   iou=openings.get("iou_mean", ""), distance=openings.get("ring_distance_m", ""),
                   mirrored=sides.get("mirrored", 0), facades=sides.get("judged", 0))
        groups = (report.get("control_points") or {}).get("groups", [])
        drawn = sum(g["drawn"] for g in groups if g["name"].startswith("window"))
        if drawn:
            row["jambs"] = sum(g["dx"]["mean_m"] * g["drawn"] for g in groups if g["name"].startswith("window")) / drawn
        (work / "evaluation.json").write_text(said.stdout)
    shutil.rmtree(out / ".store", ignore_errors=True)
    return row


def mean_of(rows, key):
    values = [float(row[key]) for row in rows if row.get(key)]
    return sum(values) / len(values) if values else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seeds", type=commands.range_of, default=(0, 3))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="")
    given = parser.parse_args()
    first, last = given.seeds
    given.folder.mkdir(parents=True, exist_ok=True)
    results = given.folder / "results.csv"
    rows = list(csv.DictReader(results.open())) if results.exists() else []
    done = {(row["arm"], int(row["seed"])) for row in rows}
    arms = given.only.split(";") if given.only else list(ARMS)
    todo = [(arm, seed) for seed in range(first, last + 1) for arm in arms if (arm, seed) not in done]
    lock = threading.Lock()

    def work(item):
        row = judge(given.program, given.folder, *item)
        with lock:
            fresh = not results.exists()
            with results.open("a", newline="") as file:
                writer = csv.DictWriter(file, fieldnames=list(row))
                if fresh:
                    writer.writeheader()
                writer.writerow(row)
            rows.append({key: str(value) for key, value in row.items()})

    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        list(pool.map(work, todo))
    print("| scene | seeds | openings found | invented | mirrored facades | outlines | jambs |\n|---|---|---|---|---|---|---|")
    for arm in ARMS:
        own = [r for r in rows if r["arm"] == arm]
        if not own:
            continue
        number = lambda key: sum(int(r[key] or 0) for r in own)
        exits = {r["exit"] for r in own if r["exit"] != "0"}
        matched = number("matched")
        weighted = sum(float(r["distance"] or 0) * int(r["matched"] or 0) for r in own)
        note = f" (exit {', '.join(sorted(exits))})" if exits else ""
        print(f"| {arm} | {len(own)} | {matched} of {number('true')}{note} | {number('found') - matched} | "
              f"{number('mirrored')} of {number('facades')} | {1000 * weighted / matched if matched else 0:.1f} mm | "
              f"{1000 * mean_of(own, 'jambs'):.1f} mm |")


if __name__ == "__main__":
    main()
