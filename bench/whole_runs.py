#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whole runs of the four products: processor time by stage, with one thread and with two, peak memory, and bytes read and written
a point; beside another program where one is given. Makes the tables of docs/performance.md.

  bench/whole_runs.py PROGRAM FOLDER [--beside OTHER] [--rounds 3] [--only planes roofs] [--scale 0.1]

Clouds are scanned into FOLDER once (10 M points of the district, 4 M of facade-haussmann, 26 M of street); roofs are the 1,644
buildings of district_east, with ILOT_DATA. Both programs run in turn with two threads, without reports; medians are given. Times
are good on a quiet machine only; bytes are those of /proc/PID/io, results included, files in memory too."""
import argparse
import json
import os
import pathlib
import shutil
import statistics
import subprocess

from measured_process import measured

DISTRICT = "roofs/city3d/district_east"
RUNS = {  # scene, million points, file, options; {} is the folder
    "planes": ("district", 10, "district.las", []),
    "facades": ("facade-haussmann", 4, "haussmann.laz", ["--products", "facades", "--stations", "{}/haussmann.stations.csv"]),
    "streets": ("street", 26, "street.laz", ["--products", "streets"]),
    "roofs": (None, 1.918, f"{DISTRICT}.las", ["--products", "roofs", "--crs", "EPSG:28992", "--set", "classes.building=[0,1,6]",
                                               "--footprints", f"{{}}/{DISTRICT}_footprints.geojson"]),
}


def arguments():
    parser = argparse.ArgumentParser(prog="bench/whole_runs.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--beside", metavar="OTHER", help="another program, e.g. of an earlier commit")
    parser.add_argument("--rounds", type=int, default=3, help="runs of each program with two threads [3]")
    parser.add_argument("--only", nargs="*", default=list(RUNS), choices=list(RUNS), metavar="PRODUCT", help="these alone [all]")
    parser.add_argument("--scale", type=float, default=1, help="of the number of scanned points [1]")
    return parser.parse_args()


def cloud_of(options, product):
    """The path of the cloud, the options of the run, and its million points; None without the data."""
    scene, millions, name, extra = RUNS[product]
    folder = options.folder if scene else os.environ.get("ILOT_DATA")
    if folder is None:
        print(f"SKIPPED: {product} need ILOT_DATA")
        return None
    path = pathlib.Path(folder) / name
    if scene:
        millions *= options.scale
        if not path.exists():
            subprocess.run([options.program, "scan", scene, "-o", path, "--points", str(round(millions * 1e6)), "-q"], check=True)
    return path, [o.format(folder) for o in extra], millions


def run(program, cloud, extra, threads, folder):
    """What one run took, with its record."""
    shutil.rmtree(folder / "out", ignore_errors=True)
    known = subprocess.run([program, "run", "--help"], capture_output=True, text=True, check=True).stdout
    quiet = ["-q"] + (["--no-report"] if "--no-report" in known else [])
    took = measured([program, "run", cloud, "-o", folder / "out", "--threads", str(threads), *quiet, *extra], folder / "log.txt")
    return {**took, "cpu": took["user"] + took["system"], "record": json.loads((folder / "out/run.json").read_text())}


def median(runs, key):
    return statistics.median(r[key] for r in runs)


def runs_of(options, product):
    """The runs of a product: ours with one thread, ours and theirs with two."""
    found = cloud_of(options, product)
    if found is None:
        return None
    cloud, extra, millions = found
    out = {"millions": millions, "one": [run(options.program, cloud, extra, 1, options.folder)], "two": [], "other": []}
    for _ in range(options.rounds):
        if options.beside:
            out["other"].append(run(options.beside, cloud, extra, 2, options.folder))
        out["two"].append(run(options.program, cloud, extra, 2, options.folder))
    if len({r["record"]["result_hash"] for r in out["one"] + out["two"]}) != 1:
        raise SystemExit(f"{product}: results differ between runs")
    return out


def serial_share(one, two):
    """The share of a stage that one thread does alone, from its seconds with one thread and with two (Karp and Flatt 1990)."""
    return max(0.0, 2 * two / one - 1) if one > 0 else 0.0


def stage_rows(product, runs):
    """By stage: processor time and how far two threads worked, and what the second one brings."""
    def of(run, name):
        return next(s for s in run["record"]["stages"] if s["name"] == name)
    for name in (s["name"] for s in runs["one"][0]["record"]["stages"]):
        seconds = statistics.median(of(r, name)["seconds"] for r in runs["two"])
        cpu = statistics.median(of(r, name)["cpu_seconds"] for r in runs["two"])
        one = of(runs["one"][0], name)["seconds"]
        if seconds > 0.02 * median(runs["two"], "seconds"):
            yield (f"| {product} | {name} | {cpu / runs['millions']:.2f} | {cpu / (2 * seconds):.2f} | {one / seconds:.2f} | "
                   f"{serial_share(one, seconds):.2f} |")


def main():
    options = arguments()
    options.folder.mkdir(parents=True, exist_ok=True)
    found = {p: r for p in options.only if (r := runs_of(options, p))}
    print("\n| run | million points | M points/s, 2 threads | 2 threads against 1 | processor s a million points | peak, MiB | "
          "bytes read a point | written |\n|---|---|---|---|---|---|---|---|")
    for product, r in found.items():
        seconds = median(r["two"], "seconds")
        print(f"| {product} | {r['millions']:g} | {r['millions'] / seconds:.2f} | {r['one'][0]['seconds'] / seconds:.2f} | "
              f"{median(r['two'], 'cpu') / r['millions']:.2f} | {median(r['two'], 'peak_mib'):.0f} | "
              f"{median(r['two'], 'read') / r['millions'] / 1e6:.0f} | {median(r['two'], 'written') / r['millions'] / 1e6:.0f} |")
    print("\n| run | stage | processor s a million points, 2 threads | share of both threads' time | 2 threads against 1 | "
          "serial share |\n|---|---|---|---|---|---|")
    for product, r in found.items():
        print("\n".join(stage_rows(product, r)))
    if options.beside:
        print("\n| run | processor time over the other's | time on the clock |\n|---|---|---|")
        for product, r in found.items():
            print(f"| {product} | {median(r['two'], 'cpu') / median(r['other'], 'cpu'):.2f} | "
                  f"{median(r['two'], 'seconds') / median(r['other'], 'seconds'):.2f} |")


if __name__ == "__main__":
    main()
