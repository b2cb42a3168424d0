#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the site of the documentation, which fails on a dead link. Skipped where mkdocs is not installed."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

if shutil.which("mkdocs") is None:
    print("SKIPPED: mkdocs is not installed")
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    built = subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--site-dir", folder], cwd=ROOT, capture_output=True, text=True)
    print(built.stderr, end="")
    sys.exit(built.returncode)
