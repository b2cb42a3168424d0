# SPDX-License-Identifier: Apache-2.0
"""What one process took (processor time, memory and bytes), and the steps of a long measurement."""
import contextlib
import json
import os
import pathlib
import subprocess
import threading
import time


def measured(command, log, codes=(0, 3)):
    """Runs a command whose output goes to the end of a log. Returns user and system seconds, seconds on the clock, the peak in MiB,
    and the bytes that it read and wrote by any call, files in memory included. The peak is never below that of this program before
    it began the command, some 20 MiB."""
    begun = time.monotonic()
    with open(log, "ab") as out:
        child = subprocess.Popen([str(c) for c in command], stdout=out, stderr=out)
        os.waitid(os.P_PID, child.pid, os.WEXITED | os.WNOWAIT)  # its counts are there until it is waited for
        counts = {}
        with contextlib.suppress(OSError):
            lines = pathlib.Path(f"/proc/{child.pid}/io").read_text().splitlines()
            counts = dict(line.split(": ") for line in lines)
        _, status, use = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode not in codes:
        raise SystemExit(f"{' '.join(map(str, command))} ended with {child.returncode}, see {log}")
    return {"user": use.ru_utime, "system": use.ru_stime, "seconds": time.monotonic() - begun, "peak_mib": use.ru_maxrss / 1024,
            "read": int(counts.get("rchar", 0)), "written": int(counts.get("wchar", 0))}


def size_of(folder):
    return sum(f.stat().st_size for f in pathlib.Path(folder).rglob("*") if f.is_file())


class Steps:
    """What steps took, one line of JSON each; a step with a line is done."""

    def __init__(self, path):
        self.path, self.lock = path, threading.Lock()
        self.done = {}
        if path.exists():
            for line in path.read_text().splitlines():
                step = json.loads(line)
                self.done[step["step"]] = step

    def run(self, name, work):
        if name in self.done:
            return
        step = {"step": name, **work()}
        with self.lock, open(self.path, "a") as out:
            self.done[name] = step
            out.write(json.dumps(step) + "\n")

    def total(self, prefix):
        return sum(s["user"] + s["system"] for n, s in self.done.items() if n.startswith(prefix))
