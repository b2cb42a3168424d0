# SPDX-License-Identifier: Apache-2.0
"""The figures of one wild scene: what `ilot evaluate --json` and run.json say, by name, and what the scene has drawn.

Each figure is better when it is larger (`+`) or smaller (`-`); DIRECTIONS says which. The main figure of a product is the
one whose loss is compared with the drawn parameters; it is a share, 1 is best.
"""
import json

VERSION = 2  # of the figures; kept results of another version are made again

SCENES = {
    "facades": ["facade-wild", "row-wild", "court-wild"],
    "roofs": ["roofs-wild"],
    "streets": ["street-wild"],
    "planes": ["facade-wild", "row-wild", "court-wild", "street-wild", "roofs-wild"],
}

MAIN = {"facades": "edges within 5 cm", "roofs": "faces matched", "streets": "detected and right", "planes": "points"}

# Names, the sign that is better, and the unit; printed in this order.
DIRECTIONS = {
    "edges within 1 cm": "+", "edges within 2 cm": "+", "edges within 5 cm": "+", "openings recall": "+",
    "openings invented": "-", "seen edges within stated": "+", "completed edges within stated": "+",
    "stated over true error": "-", "mirrored": "-",
    "faces matched": "+", "faces invented": "-", "right neighbours": "+", "heights rms, m": "-", "covered": "+",
    "outline p95, m": "-", "closed": "+",
    "detected": "+", "false": "-", "right class": "+", "detected and right": "+", "calibration error": "-",
    "class ground": "+", "class facade": "+", "class vegetation": "+",
    "trees found": "+", "trees false": "-", "trees p95, m": "-", "trees with trunk p95, m": "-", "tree heights p50, m": "-",
    "kerbs complete": "+", "kerbs correct": "+", "kerbs plan p95, m": "-", "kerbs height p95, m": "-",
    "pavements complete": "+", "pavement widths p50, m": "-", "pavement widths within 10 cm": "+", "passable widths p50, m": "-",
    "carriageways complete": "+", "carriageways correct": "+",
    "points": "+", "planes matched": "+", "planes under": "-",
    "cpu s a million points": "-", "peak MiB": "-",
}


def share(part, whole):
    return part / whole if whole else None


def of_facades(e):
    found = {}
    for limit in e.get("edges", {}).get("within", []):
        found[f"edges within {round(100 * limit['limit_m'])} cm"] = limit["share"]
    for stated in e.get("edges", {}).get("stated", []):
        found[f"{stated['status']} edges within stated"] = share(stated["within"], stated["edges"])
        if stated["status"] == "seen" and stated["median_true_m"]:
            found["stated over true error"] = stated["median_stated_m"] / stated["median_true_m"]
    if e.get("facades", {}).get("judged"):
        found["mirrored"] = e["facades"]["mirrored"] / e["facades"]["judged"]
    if "openings" in e:
        found["openings recall"] = share(e["openings"]["matched"], e["openings"]["true"])
        found["openings invented"] = share(e["openings"]["invented"], e["openings"]["found"]) or 0
    return found


def of_roofs(e):
    r = e.get("roofs")
    if not r:
        return {}
    matched = sum(size["matched"] for size in r["sizes"])
    return {"faces matched": share(r["faces_matched"], r["faces_true"]),
            "faces invented": share(r["faces_found"] - r["faces_matched"], r["faces_found"]),
            "right neighbours": share(sum(size["right_neighbours"] for size in r["sizes"]), matched),
            "heights rms, m": r["rms_m"], "covered": r["covered"], "outline p95, m": r["outline_p95_m"],
            "closed": share(r["closed"], r["models"])}


def of_streets(e):
    found = {}
    objects = e.get("objects")
    if objects:
        found = {"detected": share(objects["detected"], objects["true"]),
                 "false": share(objects["false"], objects["found"]) or 0, "right class": objects["right_class"],
                 "detected and right": objects["detected_and_right"]}
    found["calibration error"] = e.get("probabilities", {}).get("calibration_error")
    confusion = e.get("confusion", {})
    for name in ("ground", "facade", "vegetation"):
        if name in confusion.get("classes", []):
            found[f"class {name}"] = confusion["sensitivity"][confusion["classes"].index(name)]
    return found | of_street_map(e)


def of_street_map(e):
    found = {}
    trees, kerbs = e.get("trees"), e.get("kerbs")
    if trees and trees["true"]:
        found = {"trees found": share(trees["matched"], trees["true"]),
                 "trees false": share(trees["false"], trees["found"]) or 0,
                 "trees p95, m": trees["position"]["p95_m"],
                 "trees with trunk p95, m": trees["position_trunk_seen"]["p95_m"],
                 "tree heights p50, m": trees["height"]["median_m"]}
    if kerbs and kerbs["true_m"] >= 10:
        found |= {"kerbs complete": kerbs["complete"], "kerbs plan p95, m": kerbs["plan"]["p95_m"],
                  "kerbs correct": kerbs["correct"] if kerbs["found_m"] > 0 else None,
                  "kerbs height p95, m": kerbs["height"]["p95_m"]}
    roads = e.get("carriageways")
    if roads and roads["true_m"] >= 10:
        found |= {"carriageways complete": roads["complete"]}
        if roads["found"]:
            found |= {"carriageways correct": roads["correct"]}
    pavements = e.get("pavements")
    if pavements and pavements["true_m"] >= 10:
        found |= {"pavements complete": pavements["complete"]}
        if pavements["width"]["count"] >= 5:
            found |= {"pavement widths p50, m": pavements["width"]["median_m"],
                      "pavement widths within 10 cm": pavements["near"],
                      "passable widths p50, m": pavements["passable"]["median_m"]}
    return found


def of_planes(e):
    if "planes" not in e:
        return {}
    p = e["planes"]
    return {"points": e["points"]["share"], "planes matched": share(p["matched"], p["true"]),
            "planes under": share(p["under"], p["found"])}


def of(product, evaluation, record):
    found = {"facades": of_facades, "roofs": of_roofs, "streets": of_streets, "planes": of_planes}[product](evaluation)
    points = sum(cloud["points"] for cloud in record["inputs"])
    if points:
        found["cpu s a million points"] = sum(stage.get("cpu_seconds", 0) for stage in record["stages"]) / points * 1e6
    if record.get("peak_rss_bytes"):
        found["peak MiB"] = record["peak_rss_bytes"] / 2 ** 20
    return {name: value for name, value in found.items() if value is not None}


def drawn_of(path):
    """The drawn parameters of a scene: values, names of choices, means over elements and shares."""
    try:
        truth = json.loads(path.read_text())
    except (OSError, ValueError):
        return {}
    drawn = {d["name"]: d.get("choice", d["value"]) for d in truth.get("drawn", [])}
    for d in truth.get("drawn_elements", []):
        if "mean" in d:
            drawn[f"{d['name']} (mean)"] = d["mean"]
    for d in truth.get("drawn_shares", []):
        if d.get("elements"):
            drawn[f"{d['name']} (happened)"] = d["happened"] / d["elements"]
    return drawn


def scanner_of(truth_file):
    """What a street was scanned from; clouds that are cut low stand apart."""
    drawn = drawn_of(truth_file)
    if drawn["street.platform"] == "air":
        return "air"
    cut = drawn["street.cut_height"] if drawn["street.cut"] == "cut" else 100
    return "cut below 2.4 m" if cut < 2.4 else drawn["street.platform"]
