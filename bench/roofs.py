#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares roofs of real clouds with the models that others made of the same points: the distances of all points to the
faces, measured by the same code (`ilot evaluate --models`), and whether the solids are valid (`ilot validate`). Needs
ILOT_DATA.

usage: bench/roofs.py [ILOT] [--maker ILOT] [--only NAME ...]
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
ONE_BUILDING = ["--points-of", "plan", "--margin", "1000"]  # all points of a cloud
BUILDINGS = ["--set", "classes.building=[0,1,6]"]  # clouds that contain only buildings


def arguments():
    parser = argparse.ArgumentParser(prog="bench/roofs.py", description=__doc__)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--maker", metavar="ILOT", help="an earlier program that makes the models; the first one judges")
    parser.add_argument("--only", nargs="*", metavar="NAME", help="these data sets alone, e.g. delft")
    return parser.parse_args()


def sets(data):
    """Name, clouds, options of the run, options of the evaluation, and the models of others (name, files beside the
    clouds)."""
    district = data / "roofs/city3d/district_east"
    rows = [("district_east", [f"{district}.las"], [*BUILDINGS, "--crs", "EPSG:28992", "--footprints",
             f"{district}_footprints.geojson"], [], [("City3D", [f"{district}_city3d.obj"])]),
            ("district_east, no footprints", [f"{district}.las"], [*BUILDINGS, "--crs", "EPSG:28992"], ["--points-of", "plan"], []),
            ("delft", [data / "delft/ahn3_cropped_1.laz"], ["--crs", "EPSG:28992", "--footprints",
             data / "delft/footprints.geojson"], ["--class", "6"], []),
            ("delft, no footprints", [data / "delft/ahn3_cropped_1.laz"], ["--crs", "EPSG:28992"], ["--class", "6"], []),
            ("ign 870000", [data / "ign/870000_6618000.las"], ["--footprints", data / "ign/870000_footprints.geojson"],
             ["--class", "6"], []),
            ("ign 77050-77060", [data / f"ign/{t}_627755_pf8.laz" for t in (77050, 77055, 77060)], [], ["--class", "6"], [])]
    for name in ("Dales3d", "Vaihingen"):
        clouds = sorted((data / "roofs/city3d" / name).glob("*.ply"))
        rows.append((name, clouds, BUILDINGS, ONE_BUILDING,
                     [("City3D", [c.with_suffix(".obj") for c in clouds])]))
    roofs = sorted((data / "roofs/point2roof").glob("roof*"))
    rows.append(("point2roof", [r / "points.xyz" for r in roofs], BUILDINGS, ONE_BUILDING,
                 [(other, [r / f"{other}.obj" for r in roofs]) for other in ("Point2Roof", "TopoLAP", "2D_dual_contouring")]))
    return rows


def call(command, fails=False):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode not in (0, 3) and not fails:
        sys.exit(f"{' '.join(str(c) for c in command)}\n{done.stderr}")
    return done.stdout


def quantile(values, share):
    values = sorted(values)
    return values[int(share * (len(values) - 1))] if values else float("nan")


def judged(ilot, models, cloud, options):
    """Returns the RMSE and the share within 0.2 m of every building, or of the whole cloud where it is one building. A
    missing model is a failure."""
    text = call([ilot, "evaluate", "--models", models, "--cloud", cloud, "--json", "--faces", "all", *options], fails=True)
    if not text:
        return [(float("inf"), 0)]
    found = json.loads(text)
    rows = [found["over_points"]] if options == ONE_BUILDING else found["list"]
    return [(r["rmse_m"] if r["rmse_m"] is not None else float("inf"), r["near_share"] or 0) for r in rows]


def line(name, who, buildings, extra):
    rmse, share = [b[0] for b in buildings], [b[1] for b in buildings]
    print(f"| {name} | {who} | {len(buildings)} | {quantile(rmse, .5):.3f} | {quantile(rmse, .9):.3f} | "
          f"{quantile(rmse, .95):.3f} | {quantile(share, .5):.3f} | {quantile(share, .1):.3f} | {extra} |", flush=True)


def measure(ilot, maker, row, folder):
    name, clouds, run_options, judge_options, rivals = row
    ours, counts = [], {"lod22": 0, "lod12": 0, "footprint_only": 0, "valid": 0}
    for batch in [[c] for c in clouds] if judge_options == ONE_BUILDING else [clouds]:
        call([maker, "run", *batch, "-o", folder, "--overwrite", "--products", "roofs", "-q", *run_options])
        record = json.loads((folder / "run.json").read_text())["counts"]["roofs"]
        counts = {key: counts[key] + record[key] for key in counts}
        models = folder / "roofs/roofs.city.jsonl"
        for cloud in batch:
            ours += judged(ilot, models, cloud, judge_options)
    line(name, "ilot", ours, ", ".join(f"{n} {key}" for key, n in counts.items()))
    for who, files in rivals:
        theirs = []
        for file, cloud in zip(files, clouds):
            theirs += judged(ilot, file, cloud, judge_options)
        line(name, who, theirs, "")


def main():
    options = arguments()
    if "ILOT_DATA" not in os.environ:
        sys.exit("bench/roofs.py: ILOT_DATA names no folder of clouds: nothing to measure")
    print("| cloud | models | buildings | RMSE median, m | p90 | p95 | within 0.2 m, median | p10 | |")
    print("|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as work:
        for row in sets(pathlib.Path(os.environ["ILOT_DATA"])):
            if not options.only or row[0].split(",")[0] in options.only:
                measure(options.ilot, options.maker or options.ilot, row, pathlib.Path(work) / "out")


if __name__ == "__main__":
    main()
