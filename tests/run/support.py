# SPDX-License-Identifier: Apache-2.0
"""Runs the whole engine from outside. ILOT_EXE is the program, ILOT_DATA the folder of real clouds."""
import csv
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import unittest

EXE = os.environ["ILOT_EXE"]
DATA = os.environ.get("ILOT_DATA")
SKIPPED = 77
SANITIZED = os.environ.get("ILOT_SANITIZE", "") != ""


def ilot(*arguments, timeout=120, **options):
    """Runs the program. A run makes no report, which tests/run/report.py tests; other tests compare whole folders."""
    if arguments[0] == "run" and "-o" in arguments:
        arguments = (*arguments, "--no-report")
    return subprocess.run([EXE, *map(str, arguments)], capture_output=True, text=True, timeout=timeout, **options)


def real(name):
    path = pathlib.Path(DATA, name)
    if not path.exists():
        raise FileNotFoundError(f"{path}: ILOT_DATA does not hold it")
    return path


class Las:
    """An uncompressed LAS file: header and records are kept as bytes, and coordinates are decoded on request."""

    def __init__(self, data):
        self.data = data
        self.start, = struct.unpack_from("<I", data, 96)
        self.length, = struct.unpack_from("<H", data, 105)
        self.scale = struct.unpack_from("<3d", data, 131)
        self.offset = struct.unpack_from("<3d", data, 155)
        self.count, = struct.unpack_from("<I", data, 107)
        if data[25] >= 4:
            self.count = struct.unpack_from("<Q", data, 247)[0] or self.count

    @staticmethod
    def read(path):
        return Las(pathlib.Path(path).read_bytes())

    def records(self):
        return [self.data[a:a + self.length]
                for a in range(self.start, self.start + self.count * self.length, self.length)]

    def raw(self):
        """Returns the integers x, y, z of every record."""
        skip = self.length - 12
        rows = self.data[self.start:self.start + self.count * self.length]
        return list(struct.iter_unpack(f"<iii{skip}x", rows))

    def points(self):
        (sx, sy, sz), (ox, oy, oz) = self.scale, self.offset
        return [(x * sx + ox, y * sy + oy, z * sz + oz) for x, y, z in self.raw()]

    def extra_bytes(self):
        """Returns name and size of every field of the extra bytes, in order."""
        at, = struct.unpack_from("<H", self.data, 94)
        for _ in range(struct.unpack_from("<I", self.data, 100)[0]):
            user, record, length = struct.unpack_from("<2x16sHH32x", self.data, at)
            if user.rstrip(b"\0") == b"LASF_Spec" and record == 4:
                fields = [self.data[i:i + 192] for i in range(at + 54, at + 54 + length, 192)]
                return [(f[4:36].rstrip(b"\0").decode(), (0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8)[f[2]]) for f in fields]
            at += 54 + length
        return []

    def labels(self):
        """Returns (plane_id, residual, boundary) of every record of a labelled cloud. These fields are adjacent."""
        fields = self.extra_bytes()
        behind = sum(size for _, size in fields[[name for name, _ in fields].index("boundary") + 1:])
        rows = self.data[self.start:self.start + self.count * self.length]
        return list(struct.iter_unpack(f"<{self.length - 9 - behind}xIfB{behind}x", rows))

    def write(self, path, records=None, offset=None, scale=None):
        """Returns the same cloud with other records, offset or scale."""
        head = bytearray(self.data[:self.start])
        records = self.records() if records is None else records
        struct.pack_into("<I", head, 107, len(records))
        if head[25] >= 4:
            struct.pack_into("<Q", head, 247, len(records))
            struct.pack_into("<QI", head, 235, 0, 0)  # the data after the points are left out
        struct.pack_into("<3d", head, 131, *(scale or self.scale))
        struct.pack_into("<3d", head, 155, *(offset or self.offset))
        pathlib.Path(path).write_bytes(bytes(head) + b"".join(records))
        return path


def small_las(path, points, scale=(0.001, 0.001, 0.001), offset=(0, 0, 0), declared=None):
    """Writes LAS 1.2, point format 0. Points are raw integers (x, y, z). A fourth value is the class (default 6)."""
    head = struct.pack("<4sHH16sBB32s32sHHHIIBHI5I", b"LASF", 0, 0, b"", 1, 2, b"test", b"test", 1, 2026, 227, 227, 0,
                       0, 20, len(points) if declared is None else declared, len(points), 0, 0, 0, 0)
    head += struct.pack("<12d", *scale, *offset, 0, 0, 0, 0, 0, 0)
    rows = b"".join(struct.pack("<iiiHBBbBH", x, y, z, 7, 0b001001, *(code or (6,)), 0, 0, 1)
                    for x, y, z, *code in points)
    pathlib.Path(path).write_bytes(head + rows)
    return path


def kill_at_work(command, folder, beginning):
    """Starts the program and kills it as soon as it has a locked folder of this name in `folder`, or when it has ended."""
    process = subprocess.Popen([EXE, *map(str, command)])
    while process.poll() is None and not list(pathlib.Path(folder).glob(f"{beginning}*/.ilot-lock")):
        time.sleep(0.002)
    process.kill()
    process.wait()


def planes_of(out):
    with open(pathlib.Path(out, "planes.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for key, value in row.items():
            row[key] = value if key == "content_id" else int(value) if key in ("plane_id", "points") else float(value)
    return rows


class RunTest(unittest.TestCase):
    """Each test has its own folder, and runs in it."""

    def setUp(self):
        self.holder = tempfile.TemporaryDirectory(prefix="ilot-run-")
        self.folder = pathlib.Path(self.holder.name)
        self.runs = 0

    def tearDown(self):
        self.holder.cleanup()

    def scan(self, scene, points, path=None, **settings):
        path = path or self.folder / f"{scene}.las"
        chosen = [word for key, value in settings.items() for word in ("--set", f"scene.{key}={value}")]
        done = ilot("scan", scene, "-o", path, "--points", points, "-q", *chosen, timeout=600)
        self.assertEqual(done.returncode, 0, done.stderr)
        return path

    def district(self, points, **settings):
        return self.scan("district", points, self.folder / f"district-{points}.las", **settings)

    def facade(self, points, scene="facade-haussmann"):
        """Returns the cloud of a facade and the options that request its plan."""
        path = self.scan(scene, points, self.folder / f"{scene}.laz")
        return path, ["--products", "facades", "--stations", path.with_suffix(".stations.csv")]

    def street(self, points):
        """Returns the cloud of a street and the options that request its objects."""
        return self.scan("street", points), ["--products", "streets"]

    def work(self, inputs, *arguments, out=None, code=0, env=None, **options):
        """Runs in a new folder. Returns the folder and its run.json."""
        self.runs += 1
        out = out or self.folder / f"out-{self.runs}"
        inputs = inputs if isinstance(inputs, (list, tuple)) else [inputs]
        done = ilot("run", *inputs, "-o", out, "-q", *arguments, env={**os.environ, **(env or {})}, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        run_json = json.loads((out / "run.json").read_text())
        for skipped in run_json["skipped"]:
            # Units of one reason are one line, which does not name all of them.
            self.assertIn(skipped["reason" if skipped["what"] == "unit" else "where"], done.stderr, "what is skipped is told")
        return out, run_json

    def within_budgets(self, budgets, inputs, *arguments, **options):
        """Expects one result for all budgets (MiB, threads), and that no budget is exceeded. Returns the run.json of
        each."""
        run_json = [self.work(inputs, "--memory", f"{memory}M", "--threads", threads, *arguments, **options)[1]
                for memory, threads in budgets]
        for (memory, threads), record in zip(budgets, run_json):
            self.assertLessEqual(record["peak_rss_bytes"], memory << 20, f"{memory}M, {threads} threads")
        self.assertEqual(len({record["result_hash"] for record in run_json}), 1)
        return run_json

    def start(self, inputs, out, *arguments, **options):
        """A run that continues while the test does something else."""
        inputs = inputs if isinstance(inputs, (list, tuple)) else [inputs]
        return subprocess.Popen([EXE, "run", *inputs, "-o", str(out), "-q", "--no-report", *map(str, arguments)],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace", **options)

    def labelled(self, out, name):
        path = self.folder / f"{out.name}-{name}.las"
        done = ilot("convert", out / "points" / f"{name}.laz", path, "-q", "--overwrite")
        self.assertEqual(done.returncode, 0, done.stderr)
        return Las.read(path)


def main(**suites):
    """Runs the suite that argv names. A suite called real needs ILOT_DATA."""
    name = sys.argv[1] if len(sys.argv) > 1 else next(iter(suites))
    if name == "real" and not DATA:
        print("SKIPPED: the tests on real clouds need ILOT_DATA, the folder that holds them", file=sys.stderr)
        sys.exit(SKIPPED)
    loader = unittest.defaultTestLoader
    suite = unittest.TestSuite(loader.loadTestsFromTestCase(case) for case in suites[name])
    done = unittest.TextTestRunner(verbosity=2).run(suite)
    sys.exit(0 if done.wasSuccessful() else 1)
