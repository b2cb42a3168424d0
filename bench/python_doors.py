#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the way through Python costs. Two measurements, printed as tables:

  overhead  `ilot run` against ilot.run() in a new interpreter, in turns: processor seconds of each, medians
  arrays    COUNT points into a run and their labels out of it: in memory against a LAS file and a LAZ file of the same points

    PYTHONPATH=build/release/python bench/python_doors.py build/release/tools/ilot [--points 10000000] [--rounds 5]
"""
import argparse
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import ilot

CALL = "import ilot, sys; ilot.run(sys.argv[1], sys.argv[2], products=['planes', 'roofs'], report=False, existing='overwrite')"


def processor_seconds(*command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def overhead(exe, folder, rounds):
    cloud = folder / "town.laz"
    subprocess.run([exe, "scan", "district", "-o", cloud, "--points", "1000000", "-q"], check=True)
    ways = {"command": [exe, "run", cloud, "-o", folder / "a", "--products", "planes,roofs", "--no-report", "--overwrite", "-q"],
            "Python": [sys.executable, "-c", CALL, cloud, folder / "b"], "import alone": [sys.executable, "-c", "import ilot"]}
    taken = {name: [] for name in ways}
    for _ in range(rounds):
        for name, command in ways.items():
            taken[name].append(processor_seconds(*command))
    middle = {name: statistics.median(values) for name, values in taken.items()}
    print("| way | processor seconds, median | lowest |\n|---|---|---|")
    for name, values in taken.items():
        print(f"| {name} | {middle[name]:.2f} | {min(values):.2f} |")
    print(f"Python over the command: {100 * (middle['Python'] / middle['command'] - 1):+.1f} %; "
          f"of these the import {100 * middle['import alone'] / middle['command']:.1f} %")


def ground(count):
    """Rolling ground at ten points a square metre, with noise of 2 cm."""
    random = np.random.default_rng(1)
    side = (count / 10) ** 0.5
    x, y = 650000 + side * random.random(count), 6860000 + side * random.random(count)
    return x, y, 3 * np.sin(x / 90) + 2 * np.cos(y / 70) + 0.02 * random.standard_normal(count)


def stages_of(inputs, out):
    """Processor seconds of all threads: until the first stage, and of each stage."""
    begun, at, now, seconds = time.process_time(), None, None, {}

    def note(stage, *_):
        nonlocal at, now
        if at is None:
            seconds["until the first stage"] = time.process_time() - begun
        elif stage != now:
            seconds[now] = seconds.get(now, 0) + time.process_time() - at
        if stage != now:
            now, at = stage, time.process_time()
    result = ilot.streets(inputs, out, report=False, existing="overwrite", progress=note)
    seconds[now] = time.process_time() - at
    return seconds, result


def arrays(folder, count):
    x, y, z = ground(count)
    ways = {"memory": ilot.Cloud(x, y, z, name="ground")}
    for name in ("las", "laz"):
        ways[name] = folder / f"ground.{name}"
        ilot.write_cloud(ways[name], x, y, z)
    table = {}
    for name, cloud in ways.items():
        table[name], result = stages_of(cloud, folder / f"out_{name}")
        begun = time.process_time()
        if name == "memory":
            label = ilot.read_labels(result.folder)["ground"]["label"]
        else:
            label = ilot.read_cloud(result.folder / result.clouds[0], extra=["label"])["label"]
        seen = np.bincount(np.asarray(label, dtype=np.uint8))
        table[name]["labels read"] = time.process_time() - begun
        print(f"{name}: {seen.sum()} labels, {seen[1]} of them ground", file=sys.stderr)
    print(f"| {count} points, processor seconds | " + " | ".join(table) + " |\n|---|" + "---|" * len(table))
    for row in dict.fromkeys(key for column in table.values() for key in column):
        print(f"| {row} | " + " | ".join(f"{column.get(row, 0):.2f}" for column in table.values()) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("exe", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=10_000_000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--only", choices=("overhead", "arrays"))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="ilot-doors-") as name:
        if options.only != "arrays":
            overhead(options.exe, pathlib.Path(name), options.rounds)
        if options.only != "overhead":
            arrays(pathlib.Path(name), options.points)


if __name__ == "__main__":
    main()
