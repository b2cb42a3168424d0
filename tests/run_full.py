#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The full tier: runs the quick tests, then every executable *.py and *.sh in tests/full, in the order of their names.

A step works on the program that ILOT_EXE names, finds tests/run/support.py through PYTHONPATH, and ends with 0
(passed), 77 (skipped: it states the reason) or any other code (failed). A failed step does not stop the others. The
output of a step is kept in build/full/STEP.log. With names as arguments only these steps run: tests/run_full.py
kills.py
"""
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
LOGS = ROOT / "build" / "full"
VERDICTS = {0: "passed", 77: "skipped"}


def steps(names):
    """Returns names and commands, the quick tests first. Without names it returns all steps."""
    found = [path for path in sorted((ROOT / "tests" / "full").glob("*")) if path.suffix in (".py", ".sh")]
    blocked = [path.name for path in found if not os.access(path, os.X_OK)]
    if blocked:
        sys.exit(f"not executable, so never run: {', '.join(blocked)} (chmod +x)")
    quick = ["ctest", "--preset", "dev", "--parallel", str(os.cpu_count())]
    every = {"quick tests": quick, **{path.name: [str(path)] for path in found}}
    unknown = sorted(set(names) - every.keys())
    if unknown:
        sys.exit(f"no such step: {', '.join(unknown)}; there is: {', '.join(every)}")
    return {name: command for name, command in every.items() if not names or name in names}


def run_step(name, command):
    """Shows and stores the output of the command. Returns its result."""
    support = os.pathsep.join(filter(None, [str(ROOT / "tests" / "run"), os.environ.get("PYTHONPATH", "")]))
    settings = {"ILOT_EXE": str(ROOT / "build" / "dev" / "tools" / "ilot"), **os.environ, "PYTHONPATH": support}
    with open(LOGS / f"{name.replace(' ', '_')}.log", "wb") as log:
        step = subprocess.Popen(command, cwd=ROOT, env=settings, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        for line in step.stdout:
            log.write(line)
            sys.stdout.buffer.write(line)
            sys.stdout.buffer.flush()
    return VERDICTS.get(step.wait(), f"FAILED (exit {step.returncode})")


def main():
    LOGS.mkdir(parents=True, exist_ok=True)
    rows = []
    for name, command in steps(sys.argv[1:]).items():
        print(f"== {name}", flush=True)
        began = time.monotonic()
        rows.append((name, run_step(name, command), time.monotonic() - began))
    print("\nfull tier:")
    for name, verdict, seconds in rows:
        print(f"  {verdict:18} {seconds:8.0f} s  {name}")
    failed = sum(verdict.startswith("FAILED") for _, verdict, _ in rows)
    print(f"{len(rows)} steps, {failed} failed; what each printed: {LOGS}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
