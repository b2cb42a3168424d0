#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tarball (packaging/tarball.py): unpacked in a folder with a space it loads its own libraries alone but for glibc's, gives the same
result as the program it was made from, and is not made without a word when it would hold parts under the GPL."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXE = os.environ["ILOT_EXE"]
MAKE = ROOT / "packaging" / "tarball.py"
sys.path.insert(0, str(MAKE.parent))
from tarball import GLIBC, GPL  # noqa: E402
from sbom import libraries_of, package_of  # noqa: E402


def expect(condition, what):
    if not condition:
        sys.exit(f"tarball: {what}")


def result(program, cloud, out):
    done = subprocess.run([program, "run", cloud, "-o", out, "--products", "planes,roofs", "-q"], capture_output=True, text=True,
                          env={"PATH": os.environ["PATH"]})
    expect(done.returncode in (0, 3), f"{program}: {done.returncode} {done.stderr}")
    return json.loads((out / "run.json").read_text())["result_hash"]


def make(packed, *options):
    return subprocess.run([MAKE, EXE, packed, *options], capture_output=True, text=True, check=True).stdout


def main():
    reduced = os.environ.get("ILOT_GDAL")
    if not reduced:
        print("SKIPPED: ILOT_GDAL does not name what packaging/reduced_gdal.sh installs; Debian's own libgdal is taken")
    with tempfile.TemporaryDirectory(prefix="ilot-tarball-") as name:
        folder = pathlib.Path(name)
        packed = folder / "ilot.tar.gz"
        has_gpl = bool(GPL & {package_of(path) for path in libraries_of(EXE)})
        refused = subprocess.run([MAKE, EXE, packed], capture_output=True, text=True)
        expect((refused.returncode != 0) == has_gpl, f"parts under the GPL: {has_gpl}, yet {refused.returncode} {refused.stderr}")
        if has_gpl:
            expect(not packed.exists() and len(refused.stderr.splitlines()) == 1, refused.stderr)
            print(make(packed, *(["--gdal", reduced] if reduced else ["--with-gpl"])), end="")
        with tarfile.open(packed) as tar:
            tar.extractall(folder / "a place")
        home = folder / "a place" / "ilot"
        text = subprocess.run(["/lib64/ld-linux-x86-64.so.2", "--library-path", home / "lib/ilot", "--list", home / "lib/ilot/ilot"],
                              capture_output=True, text=True, check=True).stdout
        loaded = re.findall(r"^\s*(\S+) => (/.+) \(0x", text, re.M)
        expect(len(loaded) > 20, text)
        for library, path in loaded:
            expect(path.startswith(str(home)) != bool(GLIBC.match(library.rsplit("/", 1)[-1])), f"{library} is taken from {path}")
        expect(not reduced or not re.search("poppler|x265|rttopo|jbig", text), text)
        cloud = folder / "d.laz"
        subprocess.run([home / "bin/ilot", "scan", "district", "-o", cloud, "--points", "100000", "-q"], check=True)
        expect(result(home / "bin/ilot", cloud, folder / "one") == result(EXE, cloud, folder / "two"), "another result")
    return 0


if __name__ == "__main__":
    sys.exit(main())
