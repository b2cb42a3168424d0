#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A fiftieth of the tiles of a district changes, in one place: `ilot plan --update` and the tasks that it leaves beside a
plan from scratch and all of its tasks, in processor seconds, and the same bytes. ILOT_EXE is the program; ILOT_POINTS, ILOT_SEED
and ILOT_DENSITY (points per m2) choose the district, ILOT_AREAS the sides of areas in metres for planes and for roofs."""
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "run"))
from support import EXE, Las  # noqa: E402

POINTS, SEED = int(os.environ.get("ILOT_POINTS", "8000000")), int(os.environ.get("ILOT_SEED", "5"))
DENSITY, AREAS = os.environ.get("ILOT_DENSITY", "12"), os.environ.get("ILOT_AREAS", "33,35").split(",")
ACROSS = 20  # tiles along each side of the district


def seconds(*command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([EXE, *map(str, command), "-q", "--threads", "1"], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(f"{' '.join(map(str, command))}: exit {done.returncode}\n{done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def tiles_of(folder):
    subprocess.run([EXE, "scan", "district", "-o", folder / "district.las", "--points", str(POINTS), "--seed", str(SEED), "-q",
                    "--set", f"scene.density={DENSITY}"], check=True)
    las, tiles = Las.read(folder / "district.las"), {}
    raw = las.raw()
    low, high = ([f(p[axis] for p in raw) for axis in (0, 1)] for f in (min, max))
    for record, p in zip(las.records(), raw):
        place = tuple(min(ACROSS - 1, ACROSS * (p[a] - low[a]) // (high[a] - low[a] + 1)) for a in (0, 1))
        tiles.setdefault(place, []).append(record)
    (folder / "tiles").mkdir()
    for (column, row), records in tiles.items():
        las.write(folder / f"tiles/{row:02}-{column:02}.las", records)
    return folder / "tiles"


def change(tiles):
    """Takes one point in three out of two rows of tiles in the middle, a fiftieth of all."""
    middle, changed = ACROSS // 2, 0
    for row in (middle, middle + 1):
        for column in range(middle, middle + ACROSS * ACROSS // 100):
            path = tiles / f"{row:02}-{column:02}.las"
            las = Las.read(path)
            las.write(path, [r for n, r in enumerate(las.records()) if n % 3])
            changed += 1
    return changed


def tasks(plan):
    """The processor seconds and the number of the tasks whose parts are missing, and the number of areas."""
    areas = [area["area"] for area in json.loads((plan / "plan.json").read_text())["areas"]]
    left = [n for n in areas if not (plan / f"parts/{n}").exists()]
    return sum(seconds("task", plan, n) for n in left), len(left), len(areas)


def hash_of(plan):
    out = plan.parent / f"out-{plan.name}"
    merge = seconds("merge", plan, "-o", out, "--no-report")
    return json.loads((out / "run.json").read_text())["result_hash"], merge


def compare(product, size, folder, tiles):
    first, updated, scratch = (folder / f"{product}-{name}" for name in ("first", "updated", "scratch"))
    seconds("plan", tiles, "-o", first, "--products", product, "--area-size", size)
    tasks(first)
    changed = change(tiles)
    planning = seconds("plan", tiles, "-o", updated, "--update", first)
    spent, left, areas = tasks(updated)
    seconds("plan", tiles, "-o", scratch, "--products", product, "--area-size", size, "--statistics", first)
    whole, _, _ = tasks(scratch)
    (kept, merge), (same, _) = hash_of(updated), hash_of(scratch)
    if kept != same:
        sys.exit(f"{product}: an update and a plan from scratch differ")
    print(f"{product}, {changed} of {ACROSS * ACROSS} tiles changed: {left} of {areas} areas run again, {spent:.1f} of {whole:.1f} s "
          f"({100 * spent / whole:.1f} %); plan {planning:.1f} s, merge {merge:.1f} s; same bytes", flush=True)


def main():
    with tempfile.TemporaryDirectory(prefix="ilot-update-") as name:
        folder = pathlib.Path(name)
        tiles = tiles_of(folder)
        for product, size in zip(("planes", "roofs"), AREAS):
            compare(product, size, folder, tiles)


if __name__ == "__main__":
    main()
