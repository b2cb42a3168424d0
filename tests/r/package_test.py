#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs the package for R against an installation of ilot (ILOT_PREFIX) and runs its checks. ILOT_EXE: the program."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXE, PREFIX = os.environ["ILOT_EXE"], pathlib.Path(os.environ["ILOT_PREFIX"])


def must(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{command}:\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background hands it on as ignored
    if not shutil.which("Rscript") or subprocess.run(["Rscript", "-e", "library(jsonlite)"], capture_output=True).returncode != 0:
        print("SKIPPED: no R, or R without jsonlite (r-base-core, r-cran-jsonlite)")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(ROOT / "r/ilot", folder / "ilot", ignore=shutil.ignore_patterns("*.o", "*.so"))
        (folder / "library").mkdir()
        configuration = next(PREFIX.glob("lib*/**/pkgconfig/ilot.pc"))
        environment = {**os.environ, "PKG_CONFIG_PATH": str(configuration.parent), "R_LIBS": str(folder / "library"),
                       "LD_LIBRARY_PATH": str(configuration.parents[1]), "ILOT_EXE": EXE,
                       "R_MAKEVARS_USER": str(folder / "Makevars")}
        (folder / "Makevars").write_text("CFLAGS = -O1 -Wall -Wextra -Werror -Wno-cast-function-type\n")
        must("R", "CMD", "INSTALL", "--no-docs", f"--library={folder / 'library'}", str(folder / "ilot"), env=environment)
        must(EXE, "scan", "district", "-o", str(folder / "town.laz"), "--points", "60000", "-q")
        must(EXE, "scan", "facade-restoration", "-o", str(folder / "front.laz"), "--points", "60000", "-q")
        print(must("Rscript", "--vanilla", str(ROOT / "tests/r/package_test.R"), str(folder), env=environment), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
