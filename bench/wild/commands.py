# SPDX-License-Identifier: Apache-2.0
"""The commands that scan, run and judge one seed of a scene, each as a list of words, on one thread."""
import argparse
import pathlib

ONE_THREAD = ["--threads", "1"]


def range_of(text):
    first, _, last = text.partition("-")
    first, last = int(first), int(last or first)
    if last < first:
        raise argparse.ArgumentTypeError(f"{text}: the first seed is above the last one")
    return first, last


def scan(exe, scene, seed, cloud, settings=(), without="", points=None):
    """`settings` are KEY=VALUE of the scene, without `scene.`; `points`: how many, as the scene has it if None."""
    sets = [word for value in settings for word in ("--set", f"scene.{value}")]
    left_out = ["--without", without] if without else []
    left_out += ["--points", str(points)] if points else []
    return [exe, "scan", scene, "--seed", str(seed), "-o", str(cloud), "--overwrite", *ONE_THREAD, *sets, *left_out]


def run(exe, cloud, out, product):
    """Stations and footprints are given where they stand beside the cloud."""
    words = [exe, "run", str(cloud), "-o", str(out), "--products", product, "--overwrite", *ONE_THREAD]
    for option, endings in (("--stations", [".stations.csv"]), ("--footprints", [".footprints.gpkg", ".footprints.geojson"])):
        beside = (pathlib.Path(cloud).with_suffix(ending) for ending in endings)
        there = next((path for path in beside if path.exists()), None)
        words += [option, str(there)] if there else []
    return words


def evaluate(exe, out, cloud):
    return [exe, "evaluate", str(out), "--truth", str(pathlib.Path(cloud).with_suffix(".truth.json")), "--json"]
