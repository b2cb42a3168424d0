#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the cost of a stray point. Each product with each kind of stray is compared with the run without strays, by
result_hash and by processor seconds (the least of --repeats runs, at most 5 % more). Prints a table. Exit code 0: all
conditions are met; 1: some are not.

    ILOT_EXE=build/release/tools/ilot tests/full/strays.py --points 1000000 --repeats 5
"""
import argparse
import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "run"))
from strays import KINDS, with_strays
from support import EXE, Las

SCENES = {"planes": "district", "roofs": "district", "streets": "street", "facades": "facade-restoration"}
MOST = 1.05


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(path, product, out, repeats):
    """Returns the result_hash and the least processor seconds."""
    seconds = []
    for _ in range(repeats):
        shutil.rmtree(out, ignore_errors=True)
        before = cpu_seconds()
        done = subprocess.run([EXE, "run", path, "-o", out, "-q", "--products", product, "--no-clouds", "--threads", "1"],
                              capture_output=True, text=True)
        seconds.append(cpu_seconds() - before)
        if done.returncode not in (0, 3):
            return done.stderr.strip(), min(seconds)
    return json.loads((out / "run.json").read_text())["result_hash"], min(seconds)


def main():
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("--points", type=int, default=1000000)
    asked.add_argument("--repeats", type=int, default=5)
    asked = asked.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory(prefix="ilot-strays-") as folder:
        folder = pathlib.Path(folder)
        for product, scene in SCENES.items():
            path = folder / f"{scene}.las"
            if not path.exists():
                subprocess.run([EXE, "scan", scene, "-o", path, "--points", str(asked.points), "-q"], check=True)
            las = Las.read(path)
            wanted, clean = run(path, product, folder / "out", asked.repeats)
            print(f"{product:8} {'none':9} {clean:8.2f} s", flush=True)
            for kind in KINDS:
                records, _, _ = with_strays(las, kind)
                stray = las.write(folder / "stray.las", records)
                found, seconds = run(stray, product, folder / "out", asked.repeats)
                passed = found == wanted and seconds <= MOST * clean
                failed += not passed
                print(f"{product:8} {kind:9} {seconds:8.2f} s {seconds / clean:6.3f} "
                      f"{'same' if found == wanted else found} {'' if passed else 'FAILED'}", flush=True)
                os.remove(stray)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
