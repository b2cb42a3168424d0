#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens reports of all products, alone and together, in Chromium and looks at them (viewer/browser_test.mjs): console,
pixels, clicks, themes, paper. Pictures of every section are kept in build/full/report. Skipped without a browser, node
or viewer/node_modules (tools/setup)."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXE = os.environ["ILOT_EXE"]
RUNS = {
    "roofs": ("district", "400000", ["--products", "planes,roofs"]),
    "facade": ("facade-restoration", "250000", ["--products", "planes,facades"]),
    "street": ("street", "500000", ["--products", "streets,planes"]),
    "all": ("street", "600000", ["--products", "planes,roofs,facades,streets"]),
}
SETTINGS = {"street": ["--set", "scene.blocks=4"], "all": ["--set", "scene.blocks=3"]}


def reports(folder):
    for name, (scene, points, arguments) in RUNS.items():
        cloud = folder / f"{name}.laz"
        subprocess.run([EXE, "scan", scene, "-o", cloud, "--points", points, "-q", *SETTINGS.get(name, [])], check=True)
        stations = cloud.with_suffix(".stations.csv")
        more = ["--stations", stations] if name == "facade" and stations.exists() else []
        done = subprocess.run([EXE, "run", cloud, "-o", folder / name, "-q", *arguments, *more])
        if done.returncode not in (0, 3):
            sys.exit(f"the run {name} failed")
        yield folder / name / "report.html"


def main():
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if not browser or not shutil.which("node"):
        print("SKIPPED: no chromium or no node (apt-get install chromium nodejs)")
        return 77
    if not (ROOT / "viewer" / "node_modules" / "playwright-core").is_dir():
        print("SKIPPED: viewer/node_modules is missing (tools/setup)")
        return 77
    pictures = ROOT / "build" / "full" / "report"
    pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="ilot-report-") as name:
        made = list(reports(pathlib.Path(name)))
        return subprocess.run(["node", ROOT / "viewer" / "browser_test.mjs", browser, pictures, *made]).returncode


if __name__ == "__main__":
    sys.exit(main())
