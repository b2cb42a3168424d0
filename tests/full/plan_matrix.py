#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""All four products of several scenes in about 1, 4, 16 and 64 areas, run by make, Dask and Slurm while three tasks are killed at
random: always the bytes of one run. Words on the command line choose scenes and engines; ILOT_POINTS is the size of the scenes,
ILOT_SEED their seed; with ILOT_DATA real clouds too. Without Slurm's daemons (root, slurm-wlm, munge) it is left out, and that is
said. Debian: python3-distributed, slurm-wlm, munge."""
import contextlib
import json
import math
import os
import pathlib
import random
import signal
import sys
import tempfile
import threading
import time

import cluster
import slurm_loopback
from cluster import EXE, hash_of, run, script

POINTS, SEED = os.environ.get("ILOT_POINTS", "300000"), os.environ.get("ILOT_SEED", "4711")
PRODUCTS = "planes,roofs,facades,streets"
KILLS, KILLS_OF_TASK = 3, 2  # make gives a task three tries
AREAS = (1, 4, 16, 64)
# scene and its options; of real clouds the path below ILOT_DATA
SCENES = {"district": ("--set", "scene.density=6"), "street": ("--set", "scene.blocks=8"), "row-wild": (), "street-wild": ()}
REAL = {"delft": ("delft/ahn3_cropped_1.laz", "--crs", "EPSG:28992", "--footprints", "delft/footprints.geojson"),
        "ign": ("ign/870000_6618000.las",)}


def tasks_of(plan):
    """The processes that run a task of the plan now, and which."""
    for process in pathlib.Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            words = (process / "cmdline").read_bytes().split(b"\0")
            if b"task" in words and str(plan).encode() in words:
                at = words.index(str(plan).encode())
                yield int(process.name), b" ".join(words[at + 1:at + 3] if words[at + 1] == b"label" else words[at + 1:at + 2])


@contextlib.contextmanager
def killing(plan, most, rng):
    """Kills tasks at random while the body runs, and gives how many in a list."""
    killed, over = [], threading.Event()

    def work():
        while not over.is_set() and len(killed) < most:
            time.sleep(rng.uniform(0.01, 0.3))
            found = [(process, task) for process, task in tasks_of(plan) if killed.count(task) < KILLS_OF_TASK]
            if found and rng.random() < 0.5:
                process, task = rng.choice(found)
                with contextlib.suppress(OSError):
                    os.kill(process, signal.SIGKILL)
                    killed.append(task)

    thread = threading.Thread(target=work)
    thread.start()
    try:
        yield killed
    finally:
        over.set()
        thread.join()


def with_make(folder, plan, areas, clouds):
    program = script(plan, "make", folder / "plan.mk")
    run("make", "-j", "2", "-f", program, f"OUT={folder}/make", f"ILOT={EXE}", *(["clouds"] if clouds else []))
    return folder / "make"


def sides(cloud):
    """Sides of square areas of which about so many cover the cloud, each side once: the least is 33 m."""
    bounds = json.loads(run(EXE, "info", "--json", cloud))[0]["bounds"]
    low, high = bounds["min"], bounds["max"]
    surface = (high[0] - low[0]) * (high[1] - low[1])
    return dict.fromkeys(max(33, round(math.sqrt(surface / areas))) if areas > 1 else 100_000 for areas in AREAS)


def compare(name, cloud, options, engines, folder):
    rng, one = random.Random(SEED), folder / "one"
    run(EXE, "run", cloud, "-o", one, "--products", PRODUCTS, "--no-report", *options, code=(0, 3))
    for side in sides(cloud):
        plan = folder / f"plan-{side}"
        run(EXE, "plan", cloud, "-o", plan, "--products", PRODUCTS, "--area-size", side, *options)
        areas = len(json.loads((plan / "plan.json").read_text())["areas"])
        for engine in engines:
            with tempfile.TemporaryDirectory(prefix="ilot-engine-") as place, killing(plan, KILLS, rng) as killed:
                begun = time.monotonic()
                same = hash_of(engine(pathlib.Path(place), plan, areas, 1)) == hash_of(one)
            print(f"{name}, {engine.__name__}: {areas} areas of {side} m, {len(killed)} tasks killed, {time.monotonic() - begun:.0f} s, "
                  f"{'the bytes of one run' if same else 'ANOTHER RESULT'}", flush=True)
            if not same or not killed:
                sys.exit(f"{name}: {'no task was killed' if same else 'another result'}")


def main():
    os.environ["ILOT"] = EXE
    engines = {"make": with_make, "dask": cluster.with_dask, "slurm": cluster.with_slurm}
    against = slurm_loopback.reason_against()
    if against:
        print(f"Slurm is left out: {against}")
        del engines["slurm"]
    chosen = set(sys.argv[1:])
    engines = [work for name, work in engines.items() if not chosen & set(engines) or name in chosen]
    scenes = {**SCENES, **REAL}
    data = os.environ.get("ILOT_DATA")
    if not data:
        print("SKIPPED: real clouds need ILOT_DATA")
    for name, options in scenes.items():
        if chosen & set(scenes) and name not in chosen or name in REAL and not data:
            continue
        with tempfile.TemporaryDirectory(prefix="ilot-matrix-") as temporary:
            folder = pathlib.Path(temporary)
            if name in REAL:
                path, *further = options
                further = [str(pathlib.Path(data, w)) if w.startswith("delft/") else w for w in further]
                compare(name, pathlib.Path(data, path), further, engines, folder)
                continue
            cloud = folder / "scene.laz"
            run(EXE, "scan", name, "-o", cloud, "--points", POINTS, "--seed", SEED, "-q", *options)
            stations = cloud.with_suffix(".stations.csv")
            compare(name, cloud, ["--stations", str(stations)] if stations.exists() else [], engines, folder)


if __name__ == "__main__":
    main()
