#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Models a town of any number of buildings as a plan, its tasks and a merge, and says what each step took.

    bench/many_buildings.py EXE --work DIR --buildings 1000000

Scans `district` (about 2,130 buildings and 4.3 million points a km2), writes the outlines of its buildings beside it,
plans roofs with them, runs the tasks by some workers and merges the parts. What is done is not done again: a stopped
start goes on where it was, in as many sittings as it takes. --rehearse runs the tasks of the first N areas only.
Everything stays in DIR: the cloud takes 8.9 GB for a million buildings, their truth 3 GB, the parts about 2 GB."""
import argparse
import concurrent.futures
import json
import pathlib
import shutil

from measured_process import Steps, measured, size_of

BUILDINGS_OF_KM2 = 2130
POINTS_OF_BUILDING = 2000


def write_outlines(models, path):
    """The ring of the ground of each building, one feature of GeoJSON a line."""
    with open(models) as lines, open(path.with_suffix(".part"), "w") as out:
        transform = json.loads(next(lines))["transform"]
        (sx, sy, _), (tx, ty, _) = transform["scale"], transform["translate"]
        for line in lines:
            feature = json.loads(line)
            building = feature["CityObjects"][feature["id"]]
            solid = building["geometry"][0]
            ground = next(i for i, s in enumerate(solid["semantics"]["surfaces"]) if s["type"] == "GroundSurface")
            shell = solid["boundaries"][0]
            face = shell[solid["semantics"]["values"][0].index(ground)][0]
            ring = [[round(feature["vertices"][v][0] * sx + tx, 4), round(feature["vertices"][v][1] * sy + ty, 4)]
                    for v in reversed(face)]
            out.write(json.dumps({"type": "Feature", "properties": {"id": feature["id"]},
                                  "geometry": {"type": "Polygon", "coordinates": [ring + ring[:1]]}}) + "\n")
    path.with_suffix(".part").rename(path)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("exe", type=pathlib.Path)
    p.add_argument("--work", type=pathlib.Path, required=True)
    p.add_argument("--buildings", type=int, default=1_000_000)
    p.add_argument("--jobs", type=int, default=2, help="tasks at once, one thread each [2]")
    p.add_argument("--memory", default="512M", help="of a worker [512M]")
    p.add_argument("--area-size", default="auto", help="metres [auto: ten million points]")
    p.add_argument("--rehearse", type=int, default=0, metavar="N", help="only the first N areas, no merge")
    a = p.parse_args()
    a.exe, a.work = a.exe.resolve(), a.work.resolve()
    a.work.mkdir(parents=True, exist_ok=True)
    steps, log = Steps(a.work / "steps.jsonl"), a.work / "log.txt"
    cloud, outlines, plan, out = (a.work / n for n in ("town.laz", "outlines.geojsonl", "plan", "out"))
    area = a.buildings / BUILDINGS_OF_KM2
    density = POINTS_OF_BUILDING * BUILDINGS_OF_KM2 / 1e6
    steps.run("scan", lambda: measured([a.exe, "scan", "district", "-o", cloud, "--overwrite", "-q", "--set",
                                        f"scene.area_km2={area:.6g}", "--set", f"scene.density={density:.6g}"], log))
    if not outlines.exists():
        write_outlines(a.work / "town.truth.city.jsonl", outlines)
    if "plan" not in steps.done:
        shutil.rmtree(plan, ignore_errors=True)
        steps.run("plan", lambda: measured([a.exe, "plan", cloud, "-o", plan, "--products", "roofs", "--footprints",
                                            outlines, "--crs", "EPSG:2154", "--memory", a.memory, "--area-size",
                                            a.area_size], log))
    areas = len(json.loads((plan / "plan.json").read_text())["areas"])
    wanted = range(1, min(areas, a.rehearse or areas) + 1)
    tasks = [n for n in wanted if f"task {n}" not in steps.done]
    options = ["--threads", "1", "--memory", a.memory]

    def task(n):
        (plan / f"parts/{n}").unlink(missing_ok=True)  # of a task that was stopped before its line was written
        steps.run(f"task {n}", lambda: measured([a.exe, "task", plan, n, *options], log))

    pool = concurrent.futures.ThreadPoolExecutor(a.jobs)
    try:
        for future in [pool.submit(task, n) for n in tasks]:
            future.result()
    finally:
        pool.shutdown(cancel_futures=True)
    if not a.rehearse and "merge" not in steps.done:
        shutil.rmtree(out, ignore_errors=True)
        steps.run("merge", lambda: measured([a.exe, "merge", plan, "-o", out, "--memory", a.memory], log))
    report(steps, areas, out, plan)


def report(steps, areas, out, plan):
    tasks = [s for n, s in steps.done.items() if n.startswith("task ")]
    print(f"areas {areas}, tasks done {len(tasks)}, peak of a task {max(s['peak_mib'] for s in tasks):.0f} MiB")
    for name in ("scan", "plan", "task ", "merge"):
        print(f"{name.strip():6s} {steps.total(name):10.1f} s of processor time")
    for name in ("plan", "merge"):
        if name in steps.done:
            print(f"{name} took {steps.done[name]['seconds']:.0f} s on the clock, {steps.done[name]['peak_mib']:.0f} MiB at most")
    print(f"plan with its parts {size_of(plan) / 1e6:.0f} MB")
    if (out / "run.json").exists():
        run = json.loads((out / "run.json").read_text())
        buildings = run["counts"]["roofs"]["buildings"]
        print(f"result {size_of(out) / 1e6:.0f} MB, result_hash {run['result_hash']}, buildings {buildings}")
        work = sum(steps.total(n) for n in ("plan", "task ", "merge"))
        print(f"{1e3 * work / buildings:.2f} ms of processor time a building")


if __name__ == "__main__":
    main()
