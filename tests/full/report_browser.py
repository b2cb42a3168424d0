#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens reports of all products, alone and together, in Chromium and looks at them (viewer/browser_test.mjs): console,
pixels, clicks, themes, paper; one beside another result and its truth, one served by ilot view, and one in Firefox where
that is installed. Pictures of every section are kept in build/full/report. Skipped without a browser, node or
viewer/node_modules (tools/setup)."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import zlib

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


def compared(folder):
    """The roofs again, beside a run with another setting and beside their truth."""
    before, now = folder / "before", folder / "compared"
    for out, detail in ((before, "0"), (now, "0.15")):
        subprocess.run([EXE, "run", folder / "roofs.laz", "-o", out, "-q", "--products", "roofs", "--set",
                        f"roofs.detail={detail}"])
    subprocess.run([EXE, "report", now, "--against", before, "--truth", folder / "roofs.truth.json"], check=True)
    return now / "report.html"


def served(folder, out):
    """Starts ilot view. Returns the process and the address that it gave to the program that opens browsers."""
    opened, tools = folder / "opened", folder / "tools"
    tools.mkdir()
    opener = tools / "xdg-open"
    opener.write_text(f'#!/bin/sh\necho "$1" > "{opened}.part" && mv "{opened}.part" "{opened}"\n')
    opener.chmod(0o755)
    process = subprocess.Popen([EXE, "view", out], env={**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"},
                               stdout=subprocess.DEVNULL)
    for _ in range(600):
        if opened.exists():
            return process, opened.read_text().strip()
        time.sleep(0.1)
    process.kill()
    sys.exit("ilot view did not open a browser within a minute")


def look_in_firefox(report, picture):
    """A picture by Firefox: there, and not one colour."""
    firefox = shutil.which("firefox-esr") or shutil.which("firefox")
    if not firefox:
        print("without Firefox (apt-get install firefox-esr)")
        return
    with tempfile.TemporaryDirectory(prefix="ilot-firefox-") as profile:
        subprocess.run([firefox, "--headless", "--no-remote", "--profile", profile, "--window-size=1200,1600", "--screenshot",
                        picture, report.as_uri()], check=True, timeout=300, stderr=subprocess.DEVNULL)
    data, at, packed = picture.read_bytes(), 8, b""
    while at < len(data):  # chunks: length, kind, content, check sum
        length = int.from_bytes(data[at:at + 4], "big")
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += length + 12
    if len(set(zlib.decompress(packed))) < 100:
        sys.exit(f"Firefox shows next to nothing: {picture}")
    print(f"Firefox: {picture.name}")


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
        made.append(compared(pathlib.Path(name)))
        look_in_firefox(made[0], pictures / "roofs-firefox.png")
        server, address = served(pathlib.Path(name), made[0].parent)
        try:
            return subprocess.run(["node", ROOT / "viewer" / "browser_test.mjs", browser, pictures, *made, address]).returncode
        finally:
            server.terminate()


if __name__ == "__main__":
    sys.exit(main())
