# SPDX-License-Identifier: Apache-2.0
# Usage: weak_symbols.py OBJECT... . Objects compiled for one instruction set must define no weak symbol: the linker
# may keep that copy for the whole program, which then fails on machines without the instruction set.
import subprocess
import sys

WEAK = set("wWvVu")


def weak_symbols(path):
    lines = subprocess.run(["nm", "--demangle", "--defined-only", path], check=True, capture_output=True, text=True).stdout
    rows = [line.split(maxsplit=2) for line in lines.splitlines()]
    return [row[2] for row in rows if len(row) == 3 and row[1] in WEAK], len(rows)


def main():
    objects = sys.argv[1:]
    if not objects:
        sys.exit("no objects given")
    found = 0
    for path in objects:
        names, symbols = weak_symbols(path)
        if symbols == 0:
            sys.exit(f"{path}: no symbols at all; is this the right file?")
        for name in names:
            print(f"{path}: weak symbol {name}")
        found += len(names)
    sys.exit(1 if found else 0)


main()
