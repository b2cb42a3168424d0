#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how far `ilot validate` agrees with val3dity 2.6, from the tables under ILOT_DATA/validity, and its time.

bench/validity.py [PROGRAM]      the rows that differ, the shares, milliseconds per building and per 50 faces"""
import csv
import json
import os
import pathlib
import resource
import subprocess
import sys


def validate(program, path):
    completed = subprocess.run([program, "validate", "--json", path], capture_output=True, text=True, check=False)
    return json.loads(completed.stdout)["files"][0]


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def compare(title, wanted, found):
    """wanted and found are codes by name; none = valid."""
    valid = sum((not wanted[name]) == (not found[name]) for name in wanted)
    same = sum(wanted[name] == found[name] for name in wanted)
    for name in wanted:
        if wanted[name] != found[name]:
            print(f"  {name}: val3dity {sorted(wanted[name])}, ilot {sorted(found[name])}")
    print(f"{title}: {len(wanted)}; valid or not agrees {valid} ({valid / len(wanted):.1%}), same codes {same} ({same / len(wanted):.1%})")


def codes(text):
    return {int(code) for code in text.split()}


def main():
    data = pathlib.Path(os.environ["ILOT_DATA"])
    program = sys.argv[1] if len(sys.argv) > 1 else "build/release/tools/ilot"
    rows = rows_of(data / "validity/expected.csv")
    found = {row["file"]: {int(c) for c in validate(program, data / "validity" / row["file"])["codes"]} for row in rows}
    compare("val3dity's tests", {row["file"]: codes(row["codes"]) for row in rows}, found)

    models = data / "roofs/city3d/district_east_city3d.obj"
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    report = validate(program, models)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    rows = rows_of(data / "validity/city3d_east_codes.csv")
    found = {row["building"]: set() for row in rows}
    for finding in report["findings"]:
        if finding["id"] in found:
            found[finding["id"]] = {fault["code"] for fault in finding["faults"]}
    compare("City3D's models", {row["building"]: codes(row["codes"]) for row in rows}, found)
    with open(models, encoding="utf-8") as file:
        faces = sum(line.startswith("f ") for line in file)
    print(f"{report['objects']} models, {faces} faces: {1000 * seconds / report['objects']:.2f} ms a model, "
          f"{1000 * 50 * seconds / faces:.2f} ms for 50 faces, reading included, one thread")


if __name__ == "__main__":
    main()
