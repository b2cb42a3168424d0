#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that --memory sets the peak for every input. All cases of memory_cases.py run with all products, budgets and
threads. The highest resident memory of the process, with mapped pages, must not exceed --memory. All runs of a case
with the same products must give one result_hash. Prints a table. Exit code 0: all conditions are met; 1: some are not.

    ILOT_EXE=build/release/tools/ilot tests/full/memory_matrix.py --cases stray --products streets --scale 0.1
"""
import argparse
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "run"))
from memory_cases import CASES, Maker

EXE = os.environ.get("ILOT_EXE", "ilot")
MOST_ADDRESSES = 6 << 30  # limit for a run that goes wrong: it ends before the machine runs out of memory
# Cases that may report at 96M that this is too little. docs/limits.md lists them.
MAY_REFUSE = {"96M": {"thousands_of_records_of_65400_bytes"}}
LATER = 8 << 20  # memory that a run may take after it has written its own peak
UNITS = {"M": 1 << 20, "G": 1 << 30}


def bytes_of(memory):
    return int(memory[:-1]) * UNITS[memory[-1]]


class Run:
    """One run under observation: its peak as the kernel counted it (VmHWM), its exit code, and run.json or its
    message."""

    def __init__(self, inputs, products, memory, threads, out, timeout):
        command = [EXE, "run", *map(str, inputs.paths), "-o", str(out), "-q", "--products", products, "--memory",
                   memory, "--threads", str(threads), *map(str, inputs.options)]
        self.peak, self.timed_out = 0, False
        start = time.monotonic()
        with tempfile.TemporaryFile("w+") as output:
            child = subprocess.Popen(command, stdout=output, stderr=output, preexec_fn=lambda: self.limit(inputs.files))
            watcher = threading.Thread(target=self.watch, args=(child.pid, timeout), daemon=True)
            watcher.start()
            _, status, usage = os.wait4(child.pid, 0)
            self.seconds = time.monotonic() - start
            child.returncode = os.waitstatus_to_exitcode(status)
            watcher.join()
            output.seek(0)
            self.output = output.read().strip()
        self.exit = child.returncode
        self.cpu = usage.ru_utime + usage.ru_stime
        record = out / "run.json"
        self.record = json.loads(record.read_text()) if record.exists() else {}
        self.hash = self.record.get("result_hash", f"exit {self.exit}")[:12]
        self.own = self.record.get("peak_rss_bytes", 0)
        self.peak = max(self.peak, self.own)  # not ru_maxrss, which starts at the size of this process

    @staticmethod
    def limit(files):
        resource.setrlimit(resource.RLIMIT_AS, (MOST_ADDRESSES, MOST_ADDRESSES))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if files:
            hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
            resource.setrlimit(resource.RLIMIT_NOFILE, (min(files, hard), hard))

    def watch(self, pid, timeout):
        """Reads VmHWM while the process runs."""
        end = time.monotonic() + timeout
        while True:
            try:
                status = pathlib.Path(f"/proc/{pid}/status").read_text()
            except OSError:
                return
            found = re.search(r"VmHWM:\s+(\d+) kB", status)
            if found is None:
                return
            self.peak = max(self.peak, int(found.group(1)) << 10)
            if time.monotonic() > end:
                self.timed_out = True
                os.kill(pid, 9)
                return
            time.sleep(0.02)


class Matrix:
    def __init__(self, options):
        self.options = options
        self.failures = []
        self.rows = []

    def run(self):
        print(f"{'case':34} {'products':16} {'memory':>6} {'thr':>3} {'peak':>7} {'exit':>4} {'cpu s':>6}  result")
        for name, (make, products) in CASES.items():
            if not re.search(self.options.cases, name):
                continue
            with tempfile.TemporaryDirectory(prefix="ilot-memory-", dir=self.options.folder) as folder:
                self.run_case(name, make, products, pathlib.Path(folder))
        print(f"{len(self.rows)} runs, {len(self.failures)} failures")
        for failure in self.failures:
            print("  " + failure)
        if self.options.json:
            pathlib.Path(self.options.json).write_text(json.dumps(self.rows, indent=1))
        return 1 if self.failures else 0

    def run_case(self, name, make, products, folder):
        inputs = make(Maker(EXE, folder, self.options.scale))
        for product in self.chosen(products):
            hashes = {}
            for memory in self.options.memory:
                for threads in self.options.threads:
                    out = folder / "out"
                    run = Run(inputs, product, memory, threads, out, self.options.timeout)
                    shutil.rmtree(out, ignore_errors=True)
                    wrong = self.evaluate(name, inputs, memory, run, hashes)
                    self.report(name, product, memory, threads, run, wrong)
            if len(hashes) > 1:
                self.failures.append(f"{name} {product}: {len(hashes)} results: {hashes}")

    def chosen(self, products):
        wanted = self.options.products or products
        if self.options.together:
            return [",".join(p for p in products if p in wanted)]
        return [p for p in products if p in wanted]

    def evaluate(self, name, inputs, memory, run, hashes):
        if run.exit == 1 and name in MAY_REFUSE.get(memory, ()) and "--memory" in run.output:
            return [] if run.peak <= bytes_of(memory) else ["over the budget"]
        wrong = []
        if run.peak > bytes_of(memory):
            wrong.append("over the budget")
        if run.timed_out:
            wrong.append("takes too long")
        elif run.exit not in inputs.exits:
            wrong.append(f"exit {run.exit}: {run.output.splitlines()[-1][:160] if run.output else ''}")
        if run.own and not 0 <= run.peak - run.own <= LATER:
            wrong.append(f"run.json says {run.own >> 20} MiB")
        if not wrong or run.record:
            hashes.setdefault(run.hash, f"{memory}/{self.options.threads}")
        return wrong

    def report(self, name, product, memory, threads, run, wrong):
        self.rows.append({"case": name, "products": product, "memory": memory, "threads": threads, "peak": run.peak,
                          "exit": run.exit, "cpu_seconds": round(run.cpu, 2), "hash": run.hash, "wrong": wrong})
        print(f"{name:34} {product:16} {memory:>6} {threads:>3} {run.peak / (1 << 20):7.1f} {run.exit:>4} "
              f"{run.cpu:6.1f}  {run.hash} {'; '.join(wrong)}", flush=True)
        self.failures += [f"{name} {product} {memory} {threads} threads: {w}" for w in wrong]


def options_of(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words = lambda text: text.split(",")
    parser.add_argument("--cases", default="", help="regular expression that names of cases match")
    parser.add_argument("--products", type=words, default=[], help="of each case only these")
    parser.add_argument("--together", action="store_true", help="all products of a case in one run")
    parser.add_argument("--memory", type=words, default=["96M", "256M", "1G", "2G"])
    parser.add_argument("--threads", type=lambda text: [int(t) for t in text.split(",")], default=[1, 2, 16])
    parser.add_argument("--scale", type=float, default=1.0, help="share of the points of each case")
    parser.add_argument("--timeout", type=float, default=1800, help="seconds of a run")
    parser.add_argument("--folder", help="where inputs and results are written, one case at a time")
    parser.add_argument("--json", help="file for the table")
    parser.add_argument("--list", action="store_true", help="names of the cases")
    return parser.parse_args(arguments)


def main(arguments):
    options = options_of(arguments)
    if options.list:
        for name, (_, products) in CASES.items():
            print(f"{name:34} {','.join(products)}")
        return 0
    return Matrix(options).run()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
