#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What one run and a plan over the same cloud cost, product by product: the tables of docs/scale.md.

    bench/scale.py EXE --work DIR [--case NAME ...]

Scans a district of 4 km2 from the air and a street from a vehicle, makes COPC of them, and measures one run and a plan in areas of
two sizes: processor time, bytes read and written by any call, bytes of the parts, the time of the merge. The results must be those
of the run. A task that reads its area from a server on the loopback tells what it fetches, beside the nodes of the octree that its
area needs. Everything stays in DIR, some 3 GB; what is there is not measured again. Other work on the machine moves times, not bytes."""
import argparse
import http.server
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from many_buildings import write_outlines  # noqa: E402
from measured_process import Steps, measured, size_of  # noqa: E402

# scene and its options, products, sides of areas in metres
CASES = {
    "roofs": ("district", "roofs", (1000, 300)),
    "planes": ("district", "planes", (1000, 300)),
    "streets, air": ("district", "streets", (1000, 300)),
    "streets": ("street", "streets", (1000, 300)),
    "facades": ("street", "facades", (1000, 300)),
}
SCENES = {
    "district": ("--set", "scene.area_km2=4", "--set", "scene.density=8"),
    "district-wide": ("--set", "scene.area_km2=10", "--set", "scene.density=4"),
    "street": ("--points", "8000000"),
}


class Files(http.server.BaseHTTPRequestHandler):
    """Parts of one file, whose bytes are counted."""

    protocol_version = "HTTP/1.1"

    def do_GET(self):
        size = self.server.path.stat().st_size
        wanted = re.match(r"bytes=(\d+)-(\d*)$", self.headers.get("Range", ""))
        first, last = (int(wanted[1]), min(int(wanted[2] or size - 1), size - 1)) if wanted else (0, size - 1)
        self.send_response(206 if wanted else 200)
        self.send_header("Content-Length", str(last - first + 1))
        self.send_header("Accept-Ranges", "bytes")
        if wanted:
            self.send_header("Content-Range", f"bytes {first}-{last}/{size}")
        self.end_headers()
        if self.command == "HEAD":
            return
        with open(self.server.path, "rb") as data:
            data.seek(first)
            part = data.read(last - first + 1)
        with self.server.lock:
            self.server.sent += len(part)
        self.wfile.write(part)

    do_HEAD = do_GET

    def log_message(self, *_):
        pass


def nodes_of(path):
    """The cubes and sizes of the nodes of a COPC file."""
    with open(path, "rb") as file:
        data = file.read(589)
    centre, half = struct.unpack_from("<3d", data, 429), struct.unpack_from("<d", data, 453)[0]
    pages, nodes = [struct.unpack_from("<2Q", data, 469)], []
    with open(path, "rb") as file:
        while pages:
            at, size = pages.pop()
            file.seek(at)
            for level, x, y, z, offset, length, points in struct.iter_unpack("<4iQ2i", file.read(size)):
                if points == -1:
                    pages.append((offset, length))
                elif points > 0:
                    side = 2 * half / 2 ** level
                    low = [centre[0] - half + x * side, centre[1] - half + y * side]
                    nodes.append((low, [v + side for v in low], length))
    return nodes


def needed(nodes, box):
    return sum(n for low, high, n in nodes
               if low[0] <= box[2] and high[0] >= box[0] and low[1] <= box[3] and high[1] >= box[1])


def prepare(exe, work, scene, log):
    cloud, copc = work / f"{scene}.laz", work / f"{scene}.copc.laz"
    if not copc.exists():
        measured([exe, "scan", scene.split("-")[0], "-o", cloud, "-q", "--overwrite", *SCENES[scene]], log)
        measured([exe, "convert", cloud, copc, "--overwrite", "--memory", "8G"], log)
    outlines = work / f"{scene}.geojsonl"
    models = cloud.with_suffix(".truth.city.jsonl")
    if models.exists() and not outlines.exists():
        write_outlines(models, outlines)
    return copc, outlines


def options_of(work, scene, products, outlines):
    options = ["--products", products]
    if products == "roofs":
        options += ["--footprints", outlines, "--crs", "EPSG:2154"]
    stations = work / f"{scene}.stations.csv"
    if "facades" in products and stations.exists():
        options += ["--stations", stations]
    return options


def hash_of(out):
    return json.loads((out / "run.json").read_text())["result_hash"]


def run_case(exe, work, name, steps, log):
    scene, products, sides = CASES[name]
    copc, outlines = prepare(exe, work, scene, log)
    options = options_of(work, scene, products, outlines)
    place = work / name.replace(", ", "-")
    place.mkdir(exist_ok=True)
    steps.run(f"{name} run", lambda: {**measured([exe, "run", copc, "-o", place / "one", "--threads", "1", "--no-clouds", "--no-report",
                                                  "--overwrite", *options], log), "hash": hash_of(place / "one")})
    for side in sides:
        plan, out = place / f"plan-{side}", place / f"out-{side}"
        if f"{name} plan {side}" not in steps.done:
            shutil.rmtree(plan, ignore_errors=True)
        if f"{name} merge {side}" not in steps.done:
            shutil.rmtree(out, ignore_errors=True)
        steps.run(f"{name} plan {side}", lambda: measured([exe, "plan", copc, "-o", plan, "--threads", "1", "--area-size", side, *options], log))
        areas = json.loads((plan / "plan.json").read_text())["areas"]
        for area in areas:
            steps.run(f"{name} task {side} {area['area']}",
                      lambda: measured([exe, "task", plan, area["area"], "--threads", "1", "-q"], log))
        steps.run(f"{name} merge {side}", lambda: {**measured([exe, "merge", plan, "-o", out, "--threads", "1", "--no-report"], log),
                                                   "hash": hash_of(out), "areas": len(areas), "parts": size_of(plan / "parts"),
                                                   "plan": size_of(plan) - size_of(plan / "parts"), "result": size_of(out)})
        if steps.done[f"{name} merge {side}"]["hash"] != steps.done[f"{name} run"]["hash"]:
            raise SystemExit(f"{name}, areas of {side} m: not the result of one run")


def fetched(exe, work, steps, log):
    """One task of roofs, an area of 1 km2 of a district of 10 km2, from a server."""
    copc, outlines = prepare(exe, work, "district-wide", log)
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Files)
    server.path, server.sent, server.lock = copc, 0, threading.Lock()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    plan = work / "plan-http"

    def task():
        shutil.rmtree(plan, ignore_errors=True)
        url = f"http://127.0.0.1:{server.server_address[1]}/{copc.name}"
        measured([exe, "plan", url, "-o", plan, "--products", "roofs", "--footprints", outlines, "--crs", "EPSG:2154",
                  "--area-size", "1000"], log)
        planned = json.loads((plan / "plan.json").read_text())
        area = max(planned["areas"], key=lambda a: a["points"])
        server.sent = 0
        took = measured([exe, "task", plan, area["area"], "--threads", "1", "-q"], log)
        box = [v * planned["frozen"]["unit"] for v in area["read_steps"][:2] + area["read_steps"][3:5]]
        return {**took, "sent": server.sent, "nodes": needed(nodes_of(copc), box), "file": copc.stat().st_size}

    steps.run("http", task)
    server.shutdown()


def table(steps):
    print("| product | areas | run, s | plan | all tasks | merge | plan, tasks and merge over the run | parts, MB | read by tasks and merge, MB | written, MB |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    done = steps.done
    for name, (_, _, sides) in CASES.items():
        for side in sides:
            if f"{name} merge {side}" not in done:
                continue
            cpu = {k: steps.total(f"{name} {k}") for k in ("run", f"plan {side}", f"task {side} ", f"merge {side}")}
            tasks = [s for n, s in done.items() if n.startswith(f"{name} task {side} ")] + [done[f"{name} merge {side}"]]
            run, plan, task, merge = cpu.values()
            last = done[f"{name} merge {side}"]
            print(f"| {name} | {last['areas']} of about {side} m | {run:.1f} | {plan / run:.2f} | {task / run:.2f} | {merge / run:.2f} | "
                  f"{(plan + task + merge) / run:.2f} | {last['parts'] / 1e6:.1f} | {sum(t['read'] for t in tasks) / 1e6:.0f} | "
                  f"{sum(t['written'] for t in tasks) / 1e6:.0f} |")
    if "http" in done:
        h = done["http"]
        print(f"\nA task of 1 km2 fetched {h['sent'] / 1e6:.2f} MB of {h['file'] / 1e6:.1f} MB; the nodes that its area and halo meet have "
              f"{h['nodes'] / 1e6:.2f} MB ({h['sent'] / h['nodes']:.3f})")


def costs(exe, steps, work):
    """Of a million points, and in brackets of a km2 that has points."""
    print("\n| product | points per m2 | plan, s | tasks, s | merge, s | read, MB | written, MB | parts, MB | result, MB |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, (scene, _, sides) in CASES.items():
        side = sides[0]
        if f"{name} merge {side}" not in steps.done:
            continue
        info = json.loads(subprocess.run([exe, "info", "--json", work / f"{scene}.copc.laz"], capture_output=True, check=True).stdout)[0]
        density, millions = info["density_per_m2"]["all_returns"], info["points"]["read"] / 1e6
        last = steps.done[f"{name} merge {side}"]
        tasks = [s for n, s in steps.done.items() if n.startswith(f"{name} task {side} ")]
        all_steps = [steps.done[f"{name} plan {side}"], *tasks, last]
        values = [steps.total(f"{name} plan {side}"), steps.total(f"{name} task {side} "), steps.total(f"{name} merge {side}"),
                  *(sum(s[k] for s in all_steps) / 1e6 for k in ("read", "written")), last["parts"] / 1e6, last["result"] / 1e6]
        cells = " | ".join(f"{v / millions:.2f} ({v / millions * density:.3g})" for v in values)
        print(f"| {name} | {density:.1f} | {cells} |")


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("exe", type=pathlib.Path)
    p.add_argument("--work", type=pathlib.Path, required=True)
    p.add_argument("--case", action="append", choices=[*CASES, "http"], help="only this one, repeatable [all]")
    a = p.parse_args()
    exe, work = a.exe.resolve(), a.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    steps, log = Steps(work / "steps.jsonl"), work / "log.txt"
    for name in a.case or [*CASES, "http"]:
        fetched(exe, work, steps, log) if name == "http" else run_case(exe, work, name, steps, log)
    table(steps)
    costs(exe, steps, work)


if __name__ == "__main__":
    main()
