#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares with the truth of a scanned scene the regions of facades [Lorraine thesis, 4.1], the bodies of elements
[Lorraine thesis, 4.2.1] and the meshes of irregularities [Lorraine thesis, 4.2.2]: what `ilot run --products facades`
found of each true part, its size against its stated uncertainty, the distance of the meshes from the exact surface,
and whether walls close at corners.

    ilot scan building --points 3000000 -o b.laz;  ilot run b.laz -o out --products facades --stations b.stations.csv
    ilot scan building --points 3000000 --set scene.noise=0 --set scene.angle_noise=0 -o exact.laz
    bench/facade_regions.py out b.truth.json [--exact exact.laz]

The exact cloud is another scan of the same scene, without noise. Its points of class bulge are on the surface.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from facade_frame import in_axes, overlap

ROOT = pathlib.Path(__file__).resolve().parent.parent
REGION = {"bulge": "irregularity"}  # by the kind of a true element; every other kind is an element
NEAR, COVER, CORNER = 0.15, 0.5, 0.005


def arguments():
    parser = argparse.ArgumentParser(prog="bench/facade_regions.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("truth", type=pathlib.Path)
    parser.add_argument("--exact", help="a scan of the same scene without noise")
    parser.add_argument("--ilot", default=str(ROOT / "build/release/tools/ilot"), help="the program [build/release]")
    parser.add_argument("--list", action="store_true", help="what is wrong, one by one")
    return parser.parse_args()


def box_in(frame, ring):
    places = [in_axes(frame, p) for p in ring]
    return [f(p[k] for p in places) for k in range(3) for f in (min, max)]


def on_facade(frame, width, ring):
    """Returns the box of a true element in the axes of a facade, or None if the element belongs to another facade."""
    box = box_in(frame, ring)
    inside = box[0] > -0.3 and box[1] < width + 0.3
    return box if inside and abs(box[4] + box[5]) / 2 < 0.3 and box[5] - box[4] < 0.05 else None


def best_match(box, candidates):
    """Returns the candidate with the greatest intersection over union."""
    share = lambda c: overlap(box, c[0])
    best = max(candidates, key=share, default=None)
    return (best, share(best)) if best and share(best) > 0 else (None, 0)


def evaluate_regions(facades, truth, show):
    true_parts, right, errors = 0, 0, {}
    used = set()
    for e in truth["elements"]:
        for facade in facades:
            box = on_facade(facade["frame"], facade["width_m"], e["ring"])
            if box is None:
                continue
            true_parts += 1
            wanted = REGION.get(e["kind"], "element")
            candidates = [(box_in(facade["frame"], f["ring"]), f) for f in facade["elements"] if f["region"] != "facade"]
            found, share = best_match(box, candidates)
            ok = found is not None and share >= (0.3 if wanted == "irregularity" else COVER) and found[1]["region"] == wanted
            right += ok
            if found is not None:
                used.add((facade["facade"], found[1]["id"]))
            if not ok and show:
                what = f"{found[1]['kind']} ({found[1]['region']}), share {share:.2f}" if found else "nothing"
                print(f"  facade {facade['facade']} true {e['kind']} {box[0]:.2f}-{box[1]:.2f} x {box[2]:.2f}-{box[3]:.2f}: {what}")
            if ok and wanted == "element" and found[1]["status"] != "occluded":
                for key in ("width", "height", "depth"):
                    if e.get(f"{key}_m"):
                        errors.setdefault(key, []).append(
                            (abs(abs(found[1][f"{key}_m"]) - abs(e[f"{key}_m"])), found[1][f"{key}_error_m"]))
            break
    elements = [(f, e) for f in facades for e in f["elements"] if e["region"] != "facade"]
    invented = [(f, e) for f, e in elements if (f["facade"], e["id"]) not in used]
    for f, e in invented if show else []:
        b = box_in(f["frame"], e["ring"])
        print(f"  facade {f['facade']} invented {e['kind']} {b[0]:.2f}-{b[1]:.2f} x {b[2]:.2f}-{b[3]:.2f}, depth {e['depth_m']:.3f}")
    return true_parts, right, len(elements), len(invented), errors


def distance_to_mesh(heights, frame, place):
    """Returns the distance along the wall's normal to the triangle above the position, or None if it is not on the
    mesh."""
    u, v, w = in_axes(frame, place)
    for a, b, c in heights:
        d = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if d == 0:
            continue
        s = ((u - a[0]) * (c[1] - a[1]) - (v - a[1]) * (c[0] - a[0])) / d
        t = ((b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0])) / d
        if s >= 0 and t >= 0 and s + t <= 1:
            return w - (a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]))
    return None


def evaluate_meshes(facades, places):
    """Returns the root mean square of the distances of exact points to each mesh, along the normal, and the number of
    points on a mesh."""
    rows = []
    for facade in facades:
        frame = facade["frame"]
        near = [p for p in places if abs(in_axes(frame, p)[2]) < NEAR]
        for e in facade["elements"]:
            if e["region"] != "irregularity":
                continue
            flat = [in_axes(frame, p) for p in e["body"]["vertices"]]
            triangles = [tuple(flat[i] for i in face) for face in e["body"]["faces"]]
            cells = {}  # of 10 cm
            for t in triangles:
                for c in {(math.floor(u * 10), math.floor(v * 10)) for u in (min(p[0] for p in t), max(p[0] for p in t))
                          for v in (min(p[1] for p in t), max(p[1] for p in t))}:
                    cells.setdefault(c, []).append(t)
            offs = []
            for p in near:
                u, v, _ = in_axes(frame, p)
                off = distance_to_mesh(cells.get((math.floor(u * 10), math.floor(v * 10)), []), frame, p)
                if off is not None:
                    offs.append(off)
            if offs:
                rows.append((math.sqrt(sum(o * o for o in offs) / len(offs)), len(offs)))
    return rows


def exact_places(ilot, cloud, number):
    with tempfile.TemporaryDirectory() as work:
        text = pathlib.Path(work) / "exact.csv"
        subprocess.run([ilot, "convert", cloud, text], check=True, capture_output=True)
        with open(text) as file:
            return [tuple(float(row[c]) for c in "xyz") for row in csv.DictReader(file)
                    if int(float(row["true_class"])) == number]


def corners_closed(facades):
    """Returns the number of ends of walls that meet the end of a neighbour, and the number of all ends."""
    rings = [next(e for e in f["elements"] if e["region"] == "facade")["ring"] for f in facades]
    closed = total = 0
    for i, ring in enumerate(rings):
        for corner in ring:
            total += 1
            closed += any(math.dist(corner, other) < CORNER for k, r in enumerate(rings) if k != i for other in r)
    return closed, total


def main():
    options = arguments()
    facades = [json.loads(f.read_text()) for f in sorted((options.out / "facades").glob("facade-*.json"))]
    truth = json.loads(options.truth.read_text())
    parts, right, elements, invented, errors = evaluate_regions(facades, truth, options.list)
    print(f"facades {len(facades)}; true parts {parts}, right region {right} ({100 * right / max(1, parts):.1f} %); "
          f"found {elements}, matched by none {invented}")
    for key, values in errors.items():
        within = sum(e <= s for e, s in values)
        quantile = sorted(e for e, _ in values)[int(0.95 * (len(values) - 1))]
        stated = sorted(s for _, s in values)[len(values) // 2]
        share = sorted(e / s for e, s in values)[int(0.95 * (len(values) - 1))]
        print(f"{key}: {len(values)} elements, within stated {100 * within / len(values):.1f} %, error p95 "
              f"{1000 * quantile:.1f} mm, stated median {1000 * stated:.1f} mm, stated over error, one by one, p95 "
              f"{1 / share:.2f}")
    print("ends of walls closed: %d of %d" % corners_closed(facades))
    if options.exact:
        number = next(int(k) for k, name in truth["classes"].items() if name == "bulge")
        rows = evaluate_meshes(facades, exact_places(options.ilot, options.exact, number))
        for rms, count in rows:
            print(f"mesh: {count} exact points on it, RMS {1000 * rms:.2f} mm")


if __name__ == "__main__":
    main()
