#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws exported 3D Tiles by NASA's 3d-tiles-renderer in headless Chromium: on the earth and without a coordinate system. Every
tile is loaded, as many triangles are drawn as the models have, and a ray through the picture gives the metadata of a building.
Pictures are kept in build/full/tiles. Skipped without chromium, node, viewer/node_modules (tools/setup) or ILOT_NPM: npm install
3d-tiles-renderer@0.5.3 three@0.180.0 in the folder that it names."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXE = os.environ["ILOT_EXE"]
sys.path.insert(0, str(ROOT / "tests/cli"))
from export_tiles_test import copied_town


def drawn(browser, folder, name):
    pictures = ROOT / "build" / "full" / "tiles"
    pictures.mkdir(parents=True, exist_ok=True)
    done = subprocess.run(["node", ROOT / "tests/full/tiles_browser.mjs", browser, folder, pictures / f"{name}.png"],
                          stdout=subprocess.PIPE, text=True, check=True)
    seen = json.loads(done.stdout)
    if seen["faults"]:
        sys.exit(f"{name}: {seen['faults']}")
    return seen


def triangles_of(folder):
    """By the indices of all primitives."""
    total = 0
    for path in (folder / "3dtiles" / "tiles").iterdir():
        data = path.read_bytes()
        gltf = json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
        total += sum(gltf["accessors"][p["indices"]]["count"] // 3 for m in gltf["meshes"] for p in m["primitives"])
    return total


def main():
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    npm = os.environ.get("ILOT_NPM", "")
    needed = [ROOT / "viewer/node_modules/playwright-core", pathlib.Path(npm) / "node_modules/3d-tiles-renderer"]
    if not browser or not shutil.which("node") or not npm or not all(p.is_dir() for p in needed):
        print(f"SKIPPED: no chromium, no node, or not all of {', '.join(map(str, needed))}")
        return 77
    with tempfile.TemporaryDirectory(prefix="ilot-tiles-") as name:
        folder = pathlib.Path(name)
        subprocess.run([EXE, "scan", "street", "-o", folder / "s.laz", "--points", "150000", "-q", "--set", "scene.blocks=2"], check=True)
        if subprocess.run([EXE, "run", folder / "s.laz", "-o", folder / "out", "--products", "roofs,streets", "-q"]).returncode not in (0, 3):
            sys.exit("the run failed")
        copied_town(folder / "out" / "roofs" / "roofs.city.jsonl")
        run = folder / "out" / "run.json"
        for name in ("earth", "nowhere"):
            if name == "nowhere":
                told = json.loads(run.read_text())
                told["crs"]["name"] = "none"
                run.write_text(json.dumps(told))
            subprocess.run([EXE, "export", folder / "out", "--to", "3dtiles", "-o", folder / name], check=True)
            seen, expected = drawn(browser, folder / name, name), triangles_of(folder / name)
            if seen["triangles"] != expected:
                sys.exit(f"{name}: {seen['triangles']} of {expected} triangles are drawn")
            if seen["tiles"] != len(list((folder / name / "3dtiles" / "tiles").iterdir())):
                sys.exit(f"{name}: {seen['tiles']} tiles were loaded")
            if not seen["metadata"]:
                sys.exit(f"{name}: no ray found metadata")
            print(f"{name}: {seen['tiles']} tiles, {expected} triangles, hit {json.dumps(seen['metadata'])[:200]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
