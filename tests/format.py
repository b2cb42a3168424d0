#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every source has the format of .clang-format. Skipped (77) without clang-format 14, because other
versions break lines differently."""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("kernels", "engine", "training", "scan", "tools", "study", "bench", "tests", "c_api", "python", "include", "examples")


def main():
    tool = shutil.which("clang-format-14") or shutil.which("clang-format")
    version = subprocess.run([tool, "--version"], capture_output=True, text=True).stdout if tool else ""
    if not re.search(r"version 14\.", version):
        print("SKIPPED: no clang-format 14")
        return 77
    files = [str(path) for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".h", ".cpp")]
    wrong = subprocess.run([tool, "--dry-run", "--Werror", *files], cwd=ROOT, capture_output=True, text=True)
    print("\n".join(line for line in wrong.stderr.splitlines() if "error:" in line)[:4000])
    print(f"{len(files)} files read")
    return 1 if wrong.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
