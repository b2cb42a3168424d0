#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scans the 27 LoD3 buildings that others modelled by hand (Ingolstadt), runs ilot on the points and counts the windows,
doors and roof faces that are found. Needs ILOT_DATA.

Each building is scanned twice with `ilot scan --model`: from stations before its sides with windows (facades), and from
flight lines (roofs). An opening counts when at least 50 pulses met it. Flush openings, of which nothing lies more than
2 cm before or behind the wall, stand apart: the geometry does not show them. An opening is found when a drawn one has an
intersection over union of 0.5 with it (`ilot evaluate`).

The buildings are in two sets by their names alone: made with, where the first byte of the SHA-256 of the name is even,
and judged on, where it is odd. Methods may be made with the first set; figures of the second set are the result.

usage: bench/lod3_openings.py [ILOT] [--only NAME ...] [--set-of made|judged] [--keep FOLDER] [--points N] [--seed S]
"""
import argparse
import csv
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEAST_RAYS, LEAST_FACE = 50, 2  # pulses, square metres
SETS = {"made": "made with", "judged": "judged on"}


def arguments():
    parser = argparse.ArgumentParser(prog="bench/lod3_openings.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ilot", nargs="?", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--only", nargs="*", metavar="NAME", help="these buildings [all]")
    parser.add_argument("--set-of", choices=SETS, help="only this set [both]")
    parser.add_argument("--keep", metavar="FOLDER", help="leave clouds and results there")
    parser.add_argument("--points", type=int, default=1000000, help="points of each scan from stations [1000000]")
    parser.add_argument("--density", type=float, default=20, help="pulses/m2 of each flight [20]")
    parser.add_argument("--seed", type=int, default=0, help="of the scanner [0]")
    parser.add_argument("--scan", action="append", default=[], metavar="KEY=VALUE", help="options of both scans")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="settings of the runs")
    parser.add_argument("--no-stations", action="store_true", help="do not tell the run where the scanners stood")
    parser.add_argument("--markdown", metavar="FILE", help="also write the table there")
    return parser.parse_args()


def set_of(name):
    return "judged" if hashlib.sha256(name.encode()).digest()[0] % 2 else "made"


def call(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(f"{' '.join(str(c) for c in command)}\n{done.stderr}")
    return done.stdout


def settings(values):
    return [word for s in values for word in ("--set", s)]


def evaluated(options, out, truth, folder, name):
    """What `ilot evaluate` says of a result and a part of the truth."""
    path = folder / f"{name}.json"
    path.write_text(json.dumps(truth))
    return json.loads(call(options.ilot, "evaluate", out, "--truth", path, "--json"))


def facades(options, model, folder):
    cloud, out = folder / "stations.laz", folder / "out_facades"
    call(options.ilot, "scan", "--model", model, "-o", cloud, "--stations", "--points", options.points, "--seed",
         options.seed, "--overwrite", "-q", *settings(["scene.closures=1", *options.scan]))
    given = [] if options.no_stations else ["--stations", cloud.with_suffix(".stations.csv")]
    call(options.ilot, "run", cloud, "-o", out, "--overwrite", "--products", "facades", "-q", *given,
         *settings(options.set))
    openings = json.loads(cloud.with_suffix(".truth.json").read_text()).get("openings", [])
    seen = [o for o in openings if o["rays"] >= LEAST_RAYS]
    parts = {"seen": seen, "relief": [o for o in seen if not o["flush"]], "flush": [o for o in seen if o["flush"]]}
    drawn = [json.loads(f.read_text()) for f in sorted((out / "facades").glob("facade-*.json"))]
    counts = {"openings": len(openings), "facades": len(drawn), "iou": 0.0, "seen_found": 0, "relief_found": 0,
              "flush_found": 0,
              "drawn": sum(e["opening"] and e["status"] != "occluded" for f in drawn for e in f["elements"])}
    for part, some in parts.items():
        counts[part] = len(some)
        if not some or not drawn:
            continue
        result = evaluated(options, out, {"openings": some}, folder, f"truth_{part}")["openings"]
        counts[f"{part}_found"] = result["matched"]
        if part == "seen":
            counts["iou"] = (result["iou_mean"] or 0) * result["matched"]
    return counts


def roofs(options, model, folder):
    cloud, out = folder / "flight.laz", folder / "out_roofs"
    call(options.ilot, "scan", "--model", model, "-o", cloud, "--flight", "--seed", options.seed, "--overwrite", "-q",
         *settings(["scene.closures=1", f"scene.density={options.density}", *options.scan]))
    call(options.ilot, "run", cloud, "-o", out, "--overwrite", "--products", "roofs", "-q", *settings(options.set))
    truth = json.loads(cloud.with_suffix(".truth.json").read_text())
    planes = [p for p in truth["planes"] if p["class"] == "roof"]
    # Faces of 2 m2 and more count: LoD3 models have hundreds of small ones on chimneys and dormers.
    counts = {"roof_faces": sum(p["area_m2"] >= LEAST_FACE for p in planes), "roof_found": 0, "roof_rms": None}
    if planes and list((out / "roofs").glob("roofs.city.jsonl")):
        result = evaluated(options, out, {"planes": truth["planes"], "buildings": truth["buildings"]}, folder, "truth_roofs")
        sizes = [s for s in result["roofs"]["sizes"] if s["from_m2"] >= LEAST_FACE]
        counts.update(roof_faces=sum(s["true"] for s in sizes), roof_found=sum(s["matched"] for s in sizes),
                      roof_rms=result["roofs"]["rms_m"])
    return counts


def add(total, counts):
    for key, value in counts.items():
        if key != "roof_rms":
            total[key] = total.get(key, 0) + value


def share(part, whole):
    return f"{part} of {whole}" + (f" ({100 * part / whole:.0f} %)" if whole else "")


def line(name, which, c):
    iou = f"{c['iou'] / c['seen_found']:.2f}" if c["seen_found"] else "-"
    rms = f"{c['roof_rms']:.2f}" if c.get("roof_rms") is not None else "-"
    return (f"| {name} | {which} | {c['openings']} | {c['seen']} | {share(c['relief_found'], c['relief'])} | "
            f"{share(c['flush_found'], c['flush'])} | {c['drawn']} | {c['drawn'] - c['seen_found']} | {iou} | "
            f"{share(c['roof_found'], c['roof_faces'])} | {rms} |")


def main():
    options = arguments()
    if "ILOT_DATA" not in os.environ:
        sys.exit("bench/lod3_openings.py: ILOT_DATA names no folder of models: nothing to measure")
    data = pathlib.Path(os.environ["ILOT_DATA"]) / "lod3"
    names = [row["name"] for row in csv.DictReader(open(data / "index.csv"))]
    names = [n for n in names if (not options.only or n in options.only) and options.set_of in (None, set_of(n))]
    lines = ["| building | set | openings | met by 50 pulses | found, with relief | found, flush | drawn | drawn in vain | "
             "mean IoU of found | roof faces of 2 m2 found | roofs RMS, m |", "|---|---|---|---|---|---|---|---|---|---|---|"]
    print("\n".join(lines), flush=True)
    totals = {}
    with tempfile.TemporaryDirectory() as work:
        for name in names:
            folder = pathlib.Path(options.keep or work) / name
            folder.mkdir(parents=True, exist_ok=True)
            model = data / f"{name}.city.json"
            counts = {**facades(options, model, folder), **roofs(options, model, folder)}
            lines.append(line(name, SETS[set_of(name)], counts))
            print(lines[-1], flush=True)
            add(totals.setdefault(set_of(name), {}), counts)
    for which, counts in sorted(totals.items(), reverse=True):
        lines.append(line("all", SETS[which], counts))
        print(lines[-1], flush=True)
    if options.markdown:
        pathlib.Path(options.markdown).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
