#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""All products, with labelled clouds, of scenes in tiles, by two workers that are killed at random, in areas of two sizes:
the bytes of one run. Prints the processor seconds of each step. ILOT_EXE is the program; ILOT_POINTS and ILOT_SEED choose the
scenes; words on the command line choose among them; with ILOT_DATA real clouds too."""
import json
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "run"))
from support import EXE, Las  # noqa: E402

POINTS, SEED = int(os.environ.get("ILOT_POINTS", "2000000")), int(os.environ.get("ILOT_SEED", "3"))
KILLS = 3
# scene, products, side of a tile in millimetres, sides of areas in metres
CASES = (("district", "planes", 150_000, (300, 100)),
         ("district", "roofs", 150_000, (300, 100)),
         ("district", "planes,roofs,streets", 150_000, (300, 100)),
         ("facade-haussmann", "facades", 9_000, (100, 33)),
         ("row-wild", "facades", 20_000, (100, 33)),
         ("street", "streets", 300_000, (500, 200)),
         ("street-air", "streets", 300_000, (500, 200)),
         ("street-wild", "planes,facades,streets", 40_000, (100, 33)))
REAL = (("amsterdam/run2_sidewalk_2386_9702.laz", "planes,facades,streets", 20_000, (100, 33)),
        ("delft/ahn3_cropped_1.laz", "planes,roofs,streets", 50_000, (100, 33),
         ("--footprints", "delft/footprints.geojson", "--crs", "EPSG:28992")),
        ("ign/870000_6618000.las", "facades,planes,roofs,streets", 50_000, (100, 33)))


def ilot(*command, code=(0,)):
    done = subprocess.run([EXE, *map(str, command)], capture_output=True, text=True)
    if done.returncode not in code:
        sys.exit(f"{' '.join(map(str, command))}: exit {done.returncode}\n{done.stderr}")


def seconds(work):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    work()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def tiles_of(folder, cloud, side):
    """The cloud as LAZ tiles."""
    ilot("convert", cloud, folder / "cloud.las")
    las, tiles = Las.read(folder / "cloud.las"), {}
    side = round(side / 1000 / las.scale[0])
    for record, (x, y, _) in zip(las.records(), las.raw()):
        tiles.setdefault((x // side, y // side), []).append(record)
    (folder / "tiles").mkdir()
    for n, place in enumerate(sorted(tiles)):
        las.write(folder / "tile.las", tiles[place])
        ilot("convert", folder / "tile.las", folder / f"tiles/{n:03}.laz", "--overwrite")
    return folder / "tiles"


def run_all(tasks, rng):
    """Two workers at a time take the tasks in random order; some processes are killed, and their tasks done again."""
    tasks, lock, killed = list(tasks), threading.Lock(), [0]
    rng.shuffle(tasks)

    def worker():
        while True:
            with lock:
                if not tasks:
                    return
                task = tasks.pop()
                kill = killed[0] < KILLS and rng.random() < 0.3
                killed[0] += kill
            process = subprocess.Popen([EXE, *map(str, task), "--threads", "1", "-q"])
            if kill:
                try:
                    process.wait(rng.uniform(0.02, 0.5))
                except subprocess.TimeoutExpired:
                    process.kill()
            code = process.wait()
            if kill and code not in (0, 3):
                with lock:
                    tasks.append(task)
            elif code not in (0, 3):
                os._exit(print(f"{task}: exit {code}", flush=True) or 1)

    workers = [threading.Thread(target=worker) for _ in range(2)]
    for thread in workers:
        thread.start()
    for thread in workers:
        thread.join()


def compare(folder, tiles, options, one, size, rng):
    plan, out = folder / f"plan-{size}", folder / f"out-{size}"
    spent = {"plan": seconds(lambda: ilot("plan", tiles, "-o", plan, *options, "--labels", "--area-size", size, "--threads", 1))}
    areas = [area["area"] for area in json.loads((plan / "plan.json").read_text())["areas"]]
    spent["tasks"] = seconds(lambda: run_all([("task", plan, n) for n in areas], rng))
    spent["merge"] = seconds(lambda: ilot("merge", plan, "-o", out, "--labels", "--no-report", "--threads", 1, code=(0, 3)))
    spent["clouds"] = seconds(lambda: run_all([("task", plan, "label", n + 1, "-o", out) for n in range(len(list(tiles.iterdir())))],
                                              rng))
    merged = json.loads((out / "run.json").read_text())
    parts = sum(part.stat().st_size for part in (plan / "parts").iterdir() if not part.name.startswith("."))
    print(f"  {len(areas)} areas of about {size} m: " + ", ".join(f"{name} {value:.1f} s" for name, value in spent.items()) +
          f"; parts {parts / 1e6:.0f} MB, merge {merged['peak_rss_bytes'] >> 20} MiB", flush=True)
    for key in ("result_hash", "results", "counts", "inputs"):
        if merged[key] != one[key]:
            sys.exit(f"{size} m: {key} differs")


def check(name, cloud, products, side, sizes, further=()):
    """Compares one run over the cloud in tiles with plans."""
    with tempfile.TemporaryDirectory(prefix="ilot-plans-") as temporary:
        folder, rng = pathlib.Path(temporary), random.Random(SEED)
        tiles, options = tiles_of(folder, cloud, side), ("--products", products, *further)
        spent = seconds(lambda: ilot("run", tiles, "-o", folder / "one", *options, "--no-report", "--threads", 1, code=(0, 3)))
        one = json.loads((folder / "one/run.json").read_text())
        print(f"{name}: {len(list(tiles.iterdir()))} tiles, {one['counts']['points']['read']:,} points, {products}: "
              f"one run {spent:.1f} s", flush=True)
        for size in sizes:
            compare(folder, tiles, options, one, size, rng)


def main():
    chosen = sys.argv[1:]
    for scene, *case in CASES:
        if chosen and scene not in chosen:
            continue
        with tempfile.TemporaryDirectory(prefix="ilot-scene-") as temporary:
            cloud = pathlib.Path(temporary) / "scene.las"
            stations = cloud.with_suffix(".stations.csv")
            ilot("scan", scene, "-o", cloud, "--points", POINTS, "--seed", SEED, "-q")
            check(scene, cloud, *case, further=("--stations", stations) if stations.exists() else ())
    data = os.environ.get("ILOT_DATA")
    if not data:
        print("SKIPPED: real clouds need ILOT_DATA")
        return
    os.chdir(data)
    for name, *case in REAL:
        if not chosen or name.split("/")[0] in chosen:
            check(name, name, *case)


if __name__ == "__main__":
    main()
