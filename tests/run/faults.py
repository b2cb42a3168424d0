#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests what the system refuses: full disks, limits of file size and of open files, missing permission, signals,
unusual names."""
import contextlib
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import time

from support import EXE, RunTest, ilot, main, small_las

SLOW = ["--threads", "1", "--block-points", "4096"]


def limits(**soft_and_hard):
    """Returns a function for subprocess that sets the limits of the child."""
    def apply():
        for name, value in soft_and_hard.items():
            resource.setrlimit(getattr(resource, f"RLIMIT_{name}"), (value, value))
    return apply


class FaultTest(RunTest):
    def failed(self, done, *words, code=1):
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertNotIn("internal error", done.stderr)
        last = done.stderr.splitlines()[-1]
        for word in words:
            self.assertIn(word, last)

    @contextlib.contextmanager
    def small_disk(self, megabytes):
        place = self.folder / "disk"
        place.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={megabytes}m", "tmpfs", place], capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("no permission to mount a small disk")
        try:
            yield place
        finally:
            subprocess.run(["umount", "-l", place], check=True)


class Disks(FaultTest):
    def fill(self, place):
        with open(place / "filler", "wb", buffering=0) as file:
            for size in (1 << 20, 1 << 12):
                with contextlib.suppress(OSError):
                    while True:
                        file.write(b"\1" * size)

    def test_a_disk_that_becomes_full(self):
        path = self.district(60000)
        _, expected = self.work(path, *SLOW)
        with self.small_disk(40) as place:
            for number, sign in enumerate(("manifest.json", "index", "cells", "rejected")):
                out = place / f"out-{number}"
                run = self.start(path, out, *SLOW)
                while run.poll() is None and not (out / ".store" / sign).exists():
                    time.sleep(0.001)
                self.fill(place)
                _, output = run.communicate(timeout=120)
                (place / "filler").unlink()
                self.assertIn(run.returncode, (0, 1), output)
                if run.returncode == 1:
                    self.assertEqual(len(output.splitlines()), 1, output)
                    self.assertIn("No space left on device", output)
                    self.assertFalse((out / "run.json").exists())
                _, run_json = self.work(path, "--resume", *SLOW, out=out)
                self.assertEqual(run_json["result_hash"], expected["result_hash"])
                shutil.rmtree(out)

    def test_a_disk_that_is_too_small(self):
        path = self.district(60000)
        with self.small_disk(2) as place:
            self.failed(ilot("run", path, "-o", place / "out", "-q"), "the run needs at most about", "--store DIR")
            self.assertEqual(list(place.iterdir()), [])

    def test_a_disk_that_cannot_be_written(self):
        path = self.district(30000)
        with self.small_disk(40) as place:
            out, run_json = self.work(path, out=place / "out")
            subprocess.run(["mount", "-o", "remount,ro", place], check=True)
            for arguments in (["--overwrite"], ["--resume", "--set", "planes.epsilon=0.03"]):
                self.failed(ilot("run", path, "-o", out, "-q", *arguments), "Read-only file system", str(out))
            self.failed(ilot("run", path, "-o", place / "new", "-q"), "Read-only file system")
            self.assertEqual(json.loads((out / "run.json").read_text()), run_json)

    def test_a_limit_of_the_size_of_files(self):
        path = self.district(60000)
        _, expected = self.work(path, *SLOW)
        for number, size in enumerate((10_000, 100_000, 400_000)):
            out = self.folder / f"limit-{number}"
            done = ilot("run", path, "-o", out, "-q", *SLOW, preexec_fn=limits(FSIZE=size))
            self.failed(done, "File too large", "ulimit -f")
            self.assertFalse((out / "run.json").exists())
            _, run_json = self.work(path, "--resume", *SLOW, out=out)
            self.assertEqual(run_json["result_hash"], expected["result_hash"])
        for extension in ("las", "laz", "ply", "csv"):
            target = self.folder / f"copy.{extension}"
            self.failed(ilot("convert", path, target, "-q", preexec_fn=limits(FSIZE=50_000)), "File too large")
            self.assertEqual(list(self.folder.glob("copy*")), [])


class Limits(FaultTest):
    def tiles(self, count, points=40):
        """Writes small tiles side by side, each a horizontal plane."""
        folder = self.folder / "tiles"
        folder.mkdir()
        for i in range(count):
            x, y = 10_000 * (i % 50), 10_000 * (i // 50)
            small_las(folder / f"tile-{i:04}.las",
                      [(x + 1000 * (k % 7) + 13 * k, y + 1000 * (k // 7) + 7 * k, 5000 + k % 3) for k in range(points)])
        return folder

    def test_more_inputs_than_files_may_be_open(self):
        tiles = self.tiles(400)
        arguments = ["--set", "planes.min_points=20", "--threads", "2"]
        _, expected = self.work(tiles, *arguments)
        _, run_json = self.work(tiles, *arguments, preexec_fn=limits(NOFILE=160))
        self.assertEqual(run_json["result_hash"], expected["result_hash"])
        self.assertEqual(len(run_json["inputs"]), 400)
        self.assertGreater(run_json["counts"]["planes"], 0)

    def test_the_usual_memory_is_half_of_what_there_is_at_most(self):
        _, run_json = self.work(self.district(5000))
        total = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
        self.assertLessEqual(run_json["memory_bytes"], max(96 << 20, total // 2))
        self.assertLessEqual(run_json["memory_bytes"], 2 << 30)

    def test_what_a_dry_run_says_is_kept(self):
        path = self.district(100000)
        for products in ("planes", "roofs", "streets", "facades"):
            with self.subTest(products):
                output = ilot("run", path, "-o", self.folder / "none", "--dry-run", "--products", products).stderr
                self.assertFalse((self.folder / "none").exists())
                self.assertRegex(output, r"about [\d,]+ s of processor time")
                self.assertRegex(output, r"at most \d+ MiB of memory")
                store = int(output.split(" MiB of disk for the store")[0].split()[-1]) << 20
                results = int(output.split(" MiB for the results")[0].split()[-1]) << 20
                out = self.folder / products
                run = self.start(path, out, "--products", products, *SLOW)
                most = 0
                while run.poll() is None:
                    most = max(most, self.bytes_in(out / ".store"))
                    time.sleep(0.01)
                self.assertIn(run.returncode, (0, 3), run.communicate()[1])
                self.assertLessEqual(most, store)
                run_json = json.loads((out / "run.json").read_text())
                self.assertLessEqual(sum(r["bytes"] for r in run_json["results"]), results)

    def bytes_in(self, folder):
        total = 0
        for where, _, names in os.walk(folder):
            for name in names:
                with contextlib.suppress(OSError):
                    total += os.stat(os.path.join(where, name)).st_size
        return total


class Signals(FaultTest):
    def wait_until_caught(self, run, how):
        """Waits until the program is loaded and has a handler for the signal."""
        while run.poll() is None:
            lines = pathlib.Path(f"/proc/{run.pid}/status").read_text().splitlines()
            caught = next(int(line.split()[1], 16) for line in lines if line.startswith("SigCgt:"))
            if caught >> (how - 1) & 1:
                return

    def test_an_early_signal(self):
        path = self.district(30000)
        for how in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            out = self.folder / f"caught-{how}"
            run = self.start(path, out, *SLOW)
            self.wait_until_caught(run, how)
            run.send_signal(how)
            _, output = run.communicate(timeout=60)
            self.assertEqual(run.returncode, 130, output)
            self.work(path, "--resume", *SLOW, out=out)
            for milliseconds in (5, 20, 60, 100):  # before it is loaded the system ends it, and nothing has begun
                out = self.folder / f"out-{how}-{milliseconds}"
                run = self.start(path, out, *SLOW)
                time.sleep(milliseconds / 1000)
                run.send_signal(how)
                _, output = run.communicate(timeout=60)
                self.assertTrue(run.returncode == 130 or (run.returncode == -how and not out.exists()),
                                f"{run.returncode} {how} after {milliseconds} ms: {output}")

    def test_a_hangup_that_is_ignored_stays_ignored(self):
        path = self.district(60000)
        run = self.start(path, self.folder / "out", *SLOW, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        while run.poll() is None and not (self.folder / "out" / ".store" / "index").exists():
            time.sleep(0.001)
        run.send_signal(signal.SIGHUP)
        _, output = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 0, output)


class Names(FaultTest):
    def test_a_name_that_is_not_utf8(self):
        name = os.fsdecode(b"caf\xe9.las")
        path = self.district(60000).rename(self.folder / name)
        log = self.folder / "log"
        out = self.folder / "out"
        for how in ((), ("--overwrite",), ("--resume",)):
            done = subprocess.run([EXE, "run", path, "-o", out, "-q", "--log-json", log, "--products",
                                   "planes,roofs,facades,streets", *how], capture_output=True)
            self.assertIn(done.returncode, (0, 3), done.stderr)
            run_json = json.loads((out / "run.json").read_bytes().decode("utf-8"))
            self.assertTrue(run_json["inputs"][0]["path"].endswith("caf\\xE9.las"), run_json["inputs"])
            self.assertEqual(run_json["inputs"][0]["output"], "points/caf\\xE9.laz")
            self.assertTrue((out / "points" / os.fsdecode(b"caf\xe9.laz")).exists())
            for line in log.read_bytes().decode("utf-8").splitlines():
                json.loads(line)
        bad = self.folder / os.fsdecode(b"\xff.las")
        bad.write_bytes(b"LASF")
        for out in (self.folder / "none", self.folder / os.fsdecode(b"\xfe")):
            done = subprocess.run([EXE, "run", bad, "-o", out, "-q"], capture_output=True)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertNotIn(b"internal error", done.stderr)
            self.assertFalse(out.exists())

    def test_the_output_of_each_input_is_recorded(self):
        for parent in ("e1/a", "e2/a"):
            (self.folder / parent).mkdir(parents=True)
            shutil.copy(self.district(5000 if parent == "e1/a" else 6000), self.folder / parent / "x.las")
        _, run_json = self.work([self.folder / "e1", self.folder / "e2"])
        self.assertEqual([(pathlib.Path(i["path"]).parent.parent.name, i["points"], i["output"]) for i in run_json["inputs"]],
                         [("e1", run_json["inputs"][0]["points"], "points/a_x.laz"),
                          ("e2", run_json["inputs"][1]["points"], "points/a_x_2.laz")])
        _, run_json = self.work(self.folder / "e1", "--no-clouds")
        self.assertNotIn("output", run_json["inputs"][0])

    def test_files_that_no_product_reads_are_named(self):
        path = self.district(5000)
        done = ilot("run", path, "-o", self.folder / "out", "-q", "--footprints", "f.gpkg", "--train", "t.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--footprints f.gpkg is not used: only the product roofs reads it", done.stderr)
        warnings = json.loads((self.folder / "out" / "run.json").read_text())["warnings"]
        self.assertEqual(len([w for w in warnings if "is not used" in w]), 2)

    def test_a_configuration_from_a_pipe(self):
        path = self.district(5000)
        done = subprocess.run([EXE, "run", path, "-o", self.folder / "out", "-q", "--config", "/dev/stdin"],
                              input="[planes]\nepsilon = 0.03\n", capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        run_json = json.loads((self.folder / "out" / "run.json").read_text())
        self.assertEqual(run_json["parameters"]["planes.epsilon"], 0.03)
        self.assertEqual(ilot("run", "--config", "/dev/null", "--print-config").returncode, 0)
        self.failed(ilot("run", "--config", self.folder, "--print-config"), "is a folder", code=2)


if __name__ == "__main__":
    main(synthetic=[Disks, Limits, Signals, Names])
