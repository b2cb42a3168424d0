#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times the whole run, from LAS on disk to labelled LAZ on disk, at growing sizes. Seconds per million points and peak
memory must not grow. The ratio of 1 to 2 threads is compared with the scaling of the machine, which is measured in
between.

usage: bench/pipeline.py BUILD_DIR WORK_DIR [MILLIONS ...]
"""
import json
import os
import statistics
import subprocess
import sys


def ceiling(build, threads):
    out = subprocess.run([f"{build}/bench/ceiling", str(threads)], check=True, capture_output=True, text=True)
    return json.loads(out.stdout)["figures"]


def scan(ilot, work, millions):
    path = f"{work}/district_{millions}m.las"
    if not os.path.exists(path):
        subprocess.run([ilot, "scan", "district", "-o", path, "--points", str(millions * 1000000), "-q"], check=True)
    return path


def run(ilot, cloud, work, threads, memory):
    out = f"{work}/out"
    command = [ilot, "run", cloud, "-o", out, "--overwrite", "-q", "--memory", memory, "--threads", str(threads)]
    subprocess.run(command, check=True)
    with open(f"{out}/run.json") as file:
        return json.load(file)


def sizes(ilot, work, millions, memory):
    rows = []
    for m in millions:
        record = run(ilot, scan(ilot, work, m), work, 2, memory)
        stages = {s["name"]: round(s["seconds"] / m, 4) for s in record["stages"]}
        rows.append({"million_points": m, "seconds_per_million": round(record["seconds"] / m, 4),
                     "peak_mib": round(record["peak_rss_bytes"] / 2**20, 1), "planes": record["counts"]["planes"],
                     "stages_seconds_per_million": stages, "result_hash": record["result_hash"]})
    return rows


def scaling(build, ilot, work, millions, repeats):
    """Makes pairs of runs, one after the other, each with the ceilings measured at that time. Returns the median of the
    ratios."""
    cloud = scan(ilot, work, millions)
    rows = []
    for _ in range(repeats):
        one, two = ceiling(build, 1), ceiling(build, 2)
        run_one, run_two = run(ilot, cloud, work, 1, "2G"), run(ilot, cloud, work, 2, "2G")
        assert run_one["result_hash"] == run_two["result_hash"]
        loop = two["loop_g_point_planes_per_s"] / one["loop_g_point_planes_per_s"]
        triad = two["triad_gb_per_s"] / one["triad_gb_per_s"]
        speedup = run_one["seconds"] / run_two["seconds"]
        rows.append({"speedup": round(speedup, 3), "loop_scaling": round(loop, 3), "triad_scaling": round(triad, 3),
                     "share_of_loop": round(speedup / loop, 3), "share_of_triad": round(speedup / triad, 3)})
    median = {key: statistics.median(row[key] for row in rows) for key in rows[0]}
    return {"million_points": millions, "median": median, "pairs": rows}


def measure(build, work, millions, repeats=5):
    os.makedirs(work, exist_ok=True)
    ilot = f"{build}/tools/ilot"
    return {"memory_limit": "256M", "sizes": sizes(ilot, work, millions, "256M"),
            "scaling": scaling(build, ilot, work, min(5, max(millions)), repeats)}


if __name__ == "__main__":
    print(json.dumps(measure(sys.argv[1], sys.argv[2], [int(m) for m in sys.argv[3:]] or [1, 10]), indent=1))
