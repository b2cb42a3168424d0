#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests the run folder: one run at a time, an old result that stays until the new one is complete, and --resume with
its comparison."""
import hashlib
import json
import os
import shutil
import signal
import subprocess
import time

from support import EXE, SANITIZED, RunTest, ilot, main

SLOW = ["--threads", "1", "--block-points", "4096"]
HERE = os.path.dirname(os.path.abspath(__file__))


class FolderTest(RunTest):
    def snapshot(self, out):
        """Returns every file that is not hidden, with the checksum of its contents."""
        return {str(p.relative_to(out)): hashlib.sha256(p.read_bytes()).hexdigest()
                for p in sorted(out.rglob("*")) if p.is_file() and not p.relative_to(out).parts[0].startswith(".")}

    def refused(self, done, *words, lines=1):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), lines, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def until(self, run, path):
        while run.poll() is None and not path.exists():
            time.sleep(0.001)

    def no_traces(self, *folders):
        for folder in folders:
            hidden = [p.name for p in folder.rglob(".*")] if folder.exists() else []
            self.assertEqual(hidden, [])


class Locks(FolderTest):
    def test_a_second_run_is_given_the_holder(self):
        path, out = self.district(100000), self.folder / "out"
        _, expected = self.work(path, *SLOW)
        first = self.start(path, out, *SLOW)
        self.until(first, out / ".store" / "manifest.json")
        who = f"process {first.pid} on "
        for arguments in ([], ["--resume"], ["--overwrite"]):
            self.refused(ilot("run", path, "-o", out, "-q", *arguments), who, "has been working in this folder since 2")
        _, output = first.communicate(timeout=120)
        self.assertEqual(first.returncode, 0, output)
        self.assertEqual(json.loads((out / "run.json").read_text())["result_hash"], expected["result_hash"])
        self.no_traces(out)

    def test_a_store_has_one_run_too(self):
        path, store = self.district(100000), self.folder / "store"
        first = self.start(path, self.folder / "a", "--store", store, *SLOW)
        self.until(first, store / "manifest.json")
        self.refused(ilot("run", path, "-o", self.folder / "b", "-q", "--store", store), f"process {first.pid} on ",
                     "give another --store")
        self.assertFalse((self.folder / "b").exists())
        _, output = first.communicate(timeout=120)
        self.assertEqual(first.returncode, 0, output)
        self.assertFalse(store.exists())
        for out in ("a", "new"):
            self.refused(ilot("run", path, "-o", self.folder / out, "-q", "--overwrite", "--store", self.folder / out),
                         "is the output folder; give another")

    def test_a_killed_run_leaves_no_lock(self):
        path, out = self.district(60000), self.folder / "out"
        first = self.start(path, out, *SLOW)
        self.until(first, out / ".store" / "manifest.json")
        first.kill()
        first.communicate()
        self.assertTrue((out / ".ilot-lock").exists())
        self.work(path, "--resume", *SLOW, out=out)
        self.no_traces(out)

    def race(self, commands):
        """Starts all at once. Returns the exit code and the output of each."""
        runs = [subprocess.Popen([EXE, "run", *map(str, c), "-q", "--no-report"], stderr=subprocess.PIPE, text=True) for c in commands]
        return [(run.communicate(timeout=120)[1], run.returncode) for run in runs]

    def check_race(self, results):
        """Expects that one run works. The other run must state why it does not work, or must have come when the first
        was done."""
        self.assertIn(0, [code for _, code in results], results)
        for output, code in results:
            if code != 0:
                self.assertEqual(code, 2, output)
                self.assertRegex(output, r"^ilot: .*(process \d+ on .* since 2|has just begun|exists already)")
                self.assertEqual(len(output.splitlines()), 1)

    def races(self, count, points=5000):
        path = self.district(points)
        _, expected = self.work(path)
        for i in range(count):
            out, store = self.folder / f"race-{i}", self.folder / f"store-{i}"
            a, b = [path, "-o", out], [path, "-o", out]
            if i % 3 == 1:
                a, b = [path, "-o", out / "a", "--store", store], [path, "-o", out / "b", "--store", store]
            if i % 3 == 2:
                first = self.start(path, out, *SLOW)
                self.until(first, out / ".store" / "manifest.json")
                first.kill()
                first.communicate()
                a, b = [*a, "--resume", *SLOW], [*b, "--resume", *SLOW]
            results = self.race([a, b])
            self.check_race(results)
            for output, code in results:
                self.assertNotIn("internal error", output)
            finished = [p for p in (out, out / "a", out / "b") if (p / "run.json").exists()]
            self.assertTrue(finished)
            for folder in finished:
                run_json = json.loads((folder / "run.json").read_text())
                self.assertEqual(run_json["result_hash"], expected["result_hash"])
            self.no_traces(out)
            shutil.rmtree(out)

    def test_races(self):
        self.races(6)


class Overwrite(FolderTest):
    OTHER = ["--set", "planes.epsilon=0.03"]

    def test_a_run_that_fails_leaves_the_old_result(self):
        path = self.district(60000)
        out, _ = self.work(path)
        before = self.snapshot(out)
        for arguments, code in ((["--bounds", "0,0,1,1"], 1), (["--set", "planes.epsilon=-1"], 2),
                                (["--footprints", "/nonexistent", "--products", "roofs"], 2)):
            done = ilot("run", path, "-o", out, "-q", "--overwrite", *arguments)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertEqual(self.snapshot(out), before)
            self.no_traces(out)
        run = self.start(path, out, "--overwrite", *self.OTHER, *SLOW)
        self.until(run, out / ".store" / "index")
        run.kill()
        run.communicate()
        self.assertEqual(self.snapshot(out), before)
        self.refused(ilot("run", path, "-o", out, "-q", "--resume", "--bounds", "0,0,1,1"), "different: area")
        _, expected = self.work(path, *self.OTHER)
        _, run_json = self.work(path, "--resume", *self.OTHER, *SLOW, out=out)
        self.assertEqual(run_json["result_hash"], expected["result_hash"])
        self.no_traces(out)

    def test_files_of_the_user_stay(self):
        path = self.district(60000)
        out, _ = self.work(path, "--products", "planes,roofs")
        own = {"notes.txt": b"mine", "points/mine.laz": b"mine too", "roofs/plan.qgz": b"and this"}
        for name, content in own.items():
            (out / name).write_bytes(content)
        _, expected = self.work(path)
        _, run_json = self.work(path, "--overwrite", out=out)
        self.assertEqual(run_json["result_hash"], expected["result_hash"])
        for name, content in own.items():
            self.assertEqual((out / name).read_bytes(), content)
        left = sorted(str(p.relative_to(out)) for p in out.rglob("*") if p.is_file())
        self.assertEqual(left, sorted([*own, "run.json", *(r["path"] for r in run_json["results"])]))
        self.assertFalse((out / "roofs" / "roofs.obj").exists(), "files of the old result go")

    def test_a_file_of_the_user_in_the_way(self):
        path, other = self.district(30000), self.district(20000)
        out, _ = self.work(path)
        (out / "points" / "district-20000.laz").write_bytes(b"mine")
        before = self.snapshot(out)
        self.refused(ilot("run", other, "-o", out, "-q", "--overwrite"), "district-20000.laz", "move it away")
        self.assertEqual(self.snapshot(out), before)
        (out / "points" / "district-20000.laz").rename(self.folder / "moved.laz")
        _, run_json = self.work(other, "--resume", out=out)
        self.assertEqual(run_json["result_hash"], self.work(other)[1]["result_hash"])

    def test_a_result_that_does_not_list_its_files(self):
        path = self.district(30000)
        out, run_json = self.work(path)
        del run_json["results"]
        (out / "run.json").write_text(json.dumps(run_json))
        before = self.snapshot(out)
        self.refused(ilot("run", path, "-o", out, "-q", "--overwrite"), "does not list the files")
        run_json["results"] = [{"path": "../district-30000.las", "bytes": 1}]
        (out / "run.json").write_text(json.dumps(run_json))
        self.refused(ilot("run", path, "-o", out, "-q", "--overwrite"), "does not list the files")
        self.assertTrue(path.exists())
        self.assertEqual(self.snapshot(out).keys(), before.keys())

    def test_a_link_elsewhere(self):
        path = self.district(30000)
        out, _ = self.work(path)
        (out / "points").rename(self.folder / "elsewhere")
        (out / "points").symlink_to(self.folder / "elsewhere")
        before = self.snapshot(self.folder / "elsewhere")
        self.refused(ilot("run", path, "-o", out, "-q", "--overwrite"), "points", "move it away")
        self.assertEqual(self.snapshot(self.folder / "elsewhere"), before)

    def shim(self):
        library = self.folder / "kill_at.so"
        done = subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", library, os.path.join(HERE, "kill_at.c"), "-ldl"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {**os.environ, "LD_PRELOAD": str(library)}

    def kill_the_swap(self, moments):
        """Kills an overwriting run at these calls of its swap. Returns how many were reached."""
        if SANITIZED:
            self.skipTest("a sanitizer must be the first library")
        path, env, reached = self.district(60000), self.shim(), 0
        first, before = self.work(path, "--products", "planes,roofs")
        _, expected = self.work(path, *self.OTHER)
        old = self.snapshot(first)
        for at in moments:
            out = self.folder / f"swap-{at}"
            shutil.copytree(first, out)
            (out / "mine.txt").write_text("mine")
            done = ilot("run", path, "-o", out, "-q", "--overwrite", *self.OTHER, env={**env, "KILL_AT": str(at)})
            if done.returncode == 0:
                break
            self.assertEqual(done.returncode, -signal.SIGKILL, done.stderr)
            reached += 1
            now = self.snapshot(out)
            del now["mine.txt"]
            if at == 1:
                self.assertEqual(now, old, "before the first step the old result is whole")
            elif "run.json" in now:  # it stands for a complete result, the old or the new one
                run_json = json.loads((out / "run.json").read_text())
                self.assertIn(run_json["result_hash"], (before["result_hash"], expected["result_hash"]))
                self.assertEqual(now.keys() - {"run.json"}, {r["path"] for r in run_json["results"]})
            _, run_json = self.work(path, "--resume", *self.OTHER, out=out)
            self.assertEqual(run_json["result_hash"], expected["result_hash"])
            left = {str(p.relative_to(out)) for p in out.rglob("*") if p.is_file()}
            self.assertEqual(left, {"mine.txt", "run.json", *(r["path"] for r in run_json["results"])})
            shutil.rmtree(out)
        return reached

    def test_killed_in_the_swap(self):
        self.assertEqual(self.kill_the_swap([1, 2, 4, 7, 11]), 5)


class Resumed(FolderTest):
    def test_of_a_finished_run_everything_is_compared(self):
        path = self.district(30000)
        stations = self.folder / "stations.csv"
        stations.write_text("x,y,z,azimuth_step_deg,elevation_step_deg\n651000,6861000,50,0.05,0.05\n")
        out, run_json = self.work(path)
        before = self.snapshot(out)
        again = ilot("run", path, "-o", out, "--resume")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("is finished, nothing is left to do", again.stderr)
        for arguments, name in ((["--bounds", "651000,6861000,651050,6861050"], "area"), (["--crs", "EPSG:2154"], "crs"),
                                (["--footprints", path], "footprints"), (["--train", path], "train"),
                                (["--stations", stations], "stations"), (["--no-clouds"], "clouds"),
                                (["--products", "planes,streets"], "products"),
                                (["--set", "planes.epsilon=0.03"], "planes.epsilon")):
            with self.subTest(name):
                unused = name in ("footprints", "train")  # a line reports this
                self.refused(ilot("run", path, "-o", out, "-q", "--resume", *arguments), f"different: {name}",
                             lines=1 + unused)
        self.assertEqual(self.snapshot(out), before)
        self.assertEqual(run_json["request"]["products"], ["planes"])

    def test_of_a_finished_run_a_changed_input_is_named(self):
        path = self.district(30000)
        out, _ = self.work(path)
        status, content = path.stat(), path.read_bytes()
        os.utime(path)
        self.refused(ilot("run", path, "-o", out, "-q", "--resume"), "different: inputs (district-30000.las changed)")
        os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
        self.assertEqual(ilot("run", path, "-o", out, "-q", "--resume").returncode, 0)
        path.write_bytes(content[:2000] + b"?" + content[2001:])
        os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
        self.refused(ilot("run", path, "-o", out, "-q", "--resume"), "different: inputs (district-30000.las changed)")
        path.write_bytes(content)
        os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
        other = self.district(20000)
        self.refused(ilot("run", path, other, "-o", out, "-q", "--resume"), "inputs (district-20000.las added)")
        self.refused(ilot("run", other, "-o", out, "-q", "--resume"), "added", "district-30000.las left out")

    def test_of_a_finished_run_that_was_changed(self):
        path = self.district(30000)
        out, run_json = self.work(path)
        planes = (out / "planes.csv").read_bytes()
        (out / "planes.csv").write_bytes(planes + b"\n")
        self.refused(ilot("run", path, "-o", out, "-q", "--resume"), "planes.csv", "--overwrite")
        (out / "planes.csv").unlink()
        self.refused(ilot("run", path, "-o", out, "-q", "--resume"), "planes.csv: is missing", "--overwrite")
        (out / "planes.csv").write_bytes(planes)
        del run_json["request"]
        (out / "run.json").write_text(json.dumps(run_json))
        self.refused(ilot("run", path, "-o", out, "-q", "--resume"), "does not record what was asked")
        for text in ("[]", "1", "{\"request\": 5, \"results\": 7, \"inputs\": {}}", "{\"products\": {}"):
            (out / "run.json").write_text(text)
            for how in ("--resume", "--overwrite"):
                self.refused(ilot("run", path, "-o", out, "-q", how))


if __name__ == "__main__":
    main(synthetic=[Locks, Overwrite, Resumed])
