#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the worst seeds of a finished call of bench/wild/run: the points, the truth (green) and the result (red), each seed
as one PNG in WORK/PRODUCT/pictures. The seeds are scanned, run and judged again by the same program.
Needs python3-numpy and python3-matplotlib.

facades: elevations of the true facades with the most openings; points by their distance from the wall.
roofs: a plan of the 60 m around the building that has most faces and of the whole; points by height.
streets: a plan; points by their label, boxes of the true objects.
planes: a plan and a side view; points by their plane, grey where they have none.

usage: /usr/bin/python3 bench/wild/pictures.py facades --seeds 0-199 --exe build/release/tools/ilot [--worst 10]
"""
import importlib.machinery
import importlib.util
import json
import pathlib
import subprocess
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import figures  # noqa: E402

MOST_POINTS = 400_000
TRUTH, RESULT = "#00a000", "#e00000"
LABELS = {1: "#b0b0b0", 2: "#dddddd", 3: "#dddddd", 4: "#3fa34d", 5: "#8c564b"}  # ground, roof, wall, vegetation, facade
OBJECT_COLOURS = plt.get_cmap("tab10")


def load_run():
    """bench/wild/run as a module; it has no ending."""
    loader = importlib.machinery.SourceFileLoader("wild_run", str(HERE / "run"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("wild_run", loader))
    loader.exec_module(module)
    return module


def points_of(exe, folder, product):
    cloud = folder / "out" / "points" / "scene.laz"
    text = folder / "points.csv"
    subprocess.run([exe, "convert", cloud if cloud.exists() else folder / "scene.laz", text, "--overwrite", "-q"], check=True)
    with open(text) as file:
        names = file.readline().strip().split(",")
    wanted = [n for n in ("x", "y", "z", "label", "plane_id") if n in names]
    table = np.loadtxt(text, delimiter=",", skiprows=1, usecols=[names.index(n) for n in wanted])
    if len(table) > MOST_POINTS:
        table = table[np.random.default_rng(0).permutation(len(table))[:MOST_POINTS]]
    return {name: table[:, k] for k, name in enumerate(wanted)}


def outline(axes, ring, colour, width=1.0, alpha=1.0):
    closed = np.vstack([ring, ring[:1]])
    axes.plot(closed[:, 0], closed[:, 1], color=colour, lw=width, alpha=alpha)


class Wall:
    """Coordinates along, up and out of a true facade; the scene's facade is the wall that its openings lie on."""

    def __init__(self, rings):
        corners = np.vstack(rings)
        self.origin = corners.mean(0)
        spread = corners[:, :2] - self.origin[:2]
        self.along = np.append(np.linalg.svd(spread, full_matrices=False)[2][0], 0)
        self.out = np.cross(self.along, [0, 0, 1])
        self.low, self.high = np.min(self.flat(corners), 0) - 2.5, np.max(self.flat(corners), 0) + 2.5

    def flat(self, places):
        d = np.asarray(places, float) - self.origin
        return np.column_stack([d @ self.along, d[:, 2]])

    def holds(self, flat):
        return ((flat > self.low) & (flat < self.high)).all(1)


def draw_facades(folder, truth, points, figure):
    by_facade = {}
    for opening in truth["openings"]:
        by_facade.setdefault(opening["facade"], []).append(np.array(opening["ring"]))
    shown = sorted(by_facade.values(), key=len, reverse=True)[:4]
    sheets = [json.loads(path.read_text()) for path in sorted((folder / "out" / "facades").glob("facade-*.json"))]
    places = np.column_stack([points[n] for n in "xyz"])
    for number, rings in enumerate(shown, 1):
        wall, axes = Wall(rings), figure.add_subplot(1, len(shown), number)
        off = (places - wall.origin) @ wall.out
        flat = wall.flat(places)
        near = wall.holds(flat) & (np.abs(off) < 1.5)
        axes.scatter(flat[near, 0], flat[near, 1], s=0.3, c=np.clip(off[near], -0.4, 0.4), cmap="gray", linewidths=0)
        for ring in rings:
            outline(axes, wall.flat(ring), TRUTH, 1.6)
        for sheet in sheets:
            for element in sheet["elements"]:
                ring = np.array(element["ring"])
                if len(ring) and np.abs((ring - wall.origin) @ wall.out).max() < 2:
                    seen = element["kind"] not in ("not seen", "possible opening")
                    outline(axes, wall.flat(ring), RESULT if element["opening"] else "#3060ff" if seen else "#e08000",
                            1.0 if element["opening"] else 0.6)
        axes.set(xlim=(wall.low[0], wall.high[0]), ylim=(wall.low[1], wall.high[1]), aspect="equal")


def roof_edges(folder):
    text = (folder / "out" / "roofs" / "roofs.city.jsonl").read_text().splitlines()
    place = json.loads(text[0])["transform"]
    for line in text[1:]:
        feature = json.loads(line)
        corners = np.array(feature["vertices"]).reshape(-1, 3) * place["scale"] + place["translate"]
        for part in feature["CityObjects"].values():
            for geometry in part.get("geometry", []):
                if str(geometry["lod"]) != "2.2" or "semantics" not in geometry:
                    continue
                kinds = [surface["type"] for surface in geometry["semantics"]["surfaces"]]
                for shell, values in zip(geometry["boundaries"], geometry["semantics"]["values"]):
                    for face, value in zip(shell, values):
                        if kinds[value] == "RoofSurface":
                            yield from (corners[ring] for ring in face)


def draw_roofs(folder, truth, points, figure):
    faces = [p for p in truth["planes"] if p["class"] == "roof"]
    drawn = list(roof_edges(folder))
    most = max(truth["buildings"], key=lambda b: len(b["faces"]))
    middle = np.mean(most["footprint"], axis=0)[:2]
    for number, half in enumerate((None, 30.0), 1):
        axes = figure.add_subplot(1, 2, number)
        axes.scatter(points["x"], points["y"], s=(0.2 if half is None else 2) * max(1, 1e5 / len(points["x"])), c=points["z"], cmap="Greys_r", linewidths=0)
        for face in faces:
            for polygon in face["polygons"]:
                outline(axes, np.array(polygon["ring"]), TRUTH, 1.4)
        for ring in drawn:
            outline(axes, ring, RESULT, 0.7)
        axes.set_aspect("equal")
        if half is not None:
            axes.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half))


def draw_streets(folder, truth, points, figure):
    boxes = [o["box"] for o in truth["objects"] if o["points"] > 0]
    middle = np.median([box["centre"][:2] for box in boxes], axis=0) if boxes else np.array([points["x"].mean(), points["y"].mean()])
    colours = np.array([matplotlib.colors.to_rgb(LABELS.get(int(v), OBJECT_COLOURS(int(v) % 10)) if v else "#f0f0f0")
                        for v in range(256)])
    order = np.argsort(points["z"])
    for number, half in enumerate((None, 25.0), 1):
        axes = figure.add_subplot(1, 2, number)
        axes.scatter(points["x"][order], points["y"][order], s=(0.2 if half is None else 1.5) * max(1, 2e5 / len(order)),
                     c=colours[np.clip(points["label"][order].astype(int), 0, 255)], linewidths=0)
        for box in boxes:
            turn = np.radians(box["heading_deg"])
            axis = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
            corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * np.array(box["size"][:2]) / 2
            outline(axes, corners @ axis + box["centre"][:2], TRUTH, 0.8)
        axes.set_aspect("equal")
        if half is not None:
            axes.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half))


def draw_planes(folder, truth, points, figure):
    colours = np.random.default_rng(1).random((4096, 3)) * 0.8
    colour = np.where(points["plane_id"][:, None] > 0, colours[points["plane_id"].astype(int) % 4096], 0.85)
    for number, (across, up) in enumerate((("x", "y"), ("x", "z"), ("y", "z")), 1):
        axes = figure.add_subplot(1, 3, number)
        axes.scatter(points[across], points[up], s=0.2, c=colour, linewidths=0)
        axes.set_aspect("equal")


DRAW = {"facades": draw_facades, "roofs": draw_roofs, "streets": draw_streets, "planes": draw_planes}


def main(arguments):
    run = load_run()
    worst = 10
    if "--worst" in arguments:
        at = arguments.index("--worst")
        worst = int(arguments[at + 1])
        arguments = arguments[:at] + arguments[at + 2:]
    options = run.options_of(arguments + ["--keep"])
    options.summary = True
    main_figure = figures.MAIN[options.product]
    records = [r for r in run.records_of(options, options.scenes or figures.SCENES[options.product])
               if r.get("figures", {}).get(main_figure) is not None]
    records.sort(key=lambda r: r["figures"][main_figure])
    pictures = options.work / options.product / "pictures"
    pictures.mkdir(parents=True, exist_ok=True)
    for rank, record in enumerate(records[:worst], 1):
        seed = run.Seed(options, record["scene"], record["seed"])
        seed.folder.mkdir(parents=True, exist_ok=True)
        seed.judge()
        truth = json.loads((seed.folder / "scene.truth.json").read_text())
        figure = plt.figure(figsize=(22, 11))
        DRAW[options.product](seed.folder, truth, points_of(options.exe, seed.folder, options.product), figure)
        figure.suptitle(f"{record['scene']} {record['seed']}: {main_figure} {record['figures'][main_figure]:.3f}")
        figure.tight_layout()
        file = pictures / f"{rank:02d}-{record['scene']}-{record['seed']}.png"
        figure.savefig(file, dpi=80)
        plt.close(figure)
        run.shutil.rmtree(seed.folder, ignore_errors=True)
        print(file, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
