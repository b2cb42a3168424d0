#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the sources of viewer/: a licence line, lines and files of bounded length, no tabs, and that node parses them."""
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent / "viewer"
MOST_COLUMNS, MOST_LINES = 180, 400


def faults_of(path, node):
    lines = path.read_text(encoding="utf-8").splitlines()
    name = path.relative_to(ROOT.parent)
    if "SPDX-License-Identifier: Apache-2.0" not in lines[0]:
        yield f"{name}:1: no licence line"
    if len(lines) > MOST_LINES:
        yield f"{name}: {len(lines)} lines, at most {MOST_LINES}"
    for number, line in enumerate(lines, 1):
        if len(line) > MOST_COLUMNS:
            yield f"{name}:{number}: {len(line)} columns, at most {MOST_COLUMNS}"
        if "\t" in line or line != line.rstrip():
            yield f"{name}:{number}: a tab, or blanks at the end"
    if node and path.suffix in (".js", ".mjs"):
        kind = ["--input-type=module"] if path.parent.name != "page" else ["--input-type=commonjs"]
        checked = subprocess.run([node, *kind, "--check"], input=path.read_text(encoding="utf-8"), capture_output=True, text=True)
        if checked.returncode:
            yield f"{name}: {checked.stderr.strip().splitlines()[-1] if checked.stderr else 'cannot be parsed'}"


def main():
    files = [p for p in sorted(ROOT.rglob("*")) if p.suffix in (".js", ".mjs", ".css") and "node_modules" not in p.parts]
    node = shutil.which("node")
    if not node:
        print("no node: the scripts are not parsed")
    faults = [fault for path in files for fault in faults_of(path, node)]
    print("\n".join(faults + [f"{len(files)} files read, {len(faults)} faults"]))
    return 1 if faults or not files else 0


if __name__ == "__main__":
    sys.exit(main())
