#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Invariant 5: a run that is killed or interrupted continues where it stopped and ends with the same bytes."""
import os
import random
import shutil
import signal
import subprocess
import time

from support import RunTest, ilot, main, real

SLOW = ["--threads", "1", "--block-points", "4096"]


class Resume(RunTest):
    def stop_after(self, seconds, how, inputs, out, *arguments):
        """Starts a run and sends the signal. Returns its exit code and its output."""
        run = self.start(inputs, out, *arguments)
        try:
            _, output = run.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            run.send_signal(how)
            _, output = run.communicate(timeout=60)
        return run.returncode, output

    def stop_in_stage(self, stage, how, inputs, out, *arguments):
        """Sends the signal as soon as a file of that stage is in the store, or among the results."""
        pattern = {"index": ".store/blocks/*.codes", "normals": ".store/blocks/*.normals", "planes": ".store/cells/*.cell",
                   "join": ".store/blocks/*.contacts", "label": ".store/blocks/*.plane", "write": ".new/points/*",
                   "facades": ".store/blocks/*.facade", "streets": ".store/blocks/*.street"}[stage]
        run = self.start(inputs, out, *arguments)
        while run.poll() is None and not any(out.glob(pattern)):
            time.sleep(0.001)
        if run.poll() is None:
            run.send_signal(how)
        _, output = run.communicate(timeout=60)
        return run.returncode, output

    def seconds_of(self, inputs, *arguments):
        began = time.monotonic()
        out, run_json = self.work(inputs, *arguments)
        return time.monotonic() - began, run_json["result_hash"], sorted(p.name for p in out.iterdir())

    def check_kills(self, inputs, moments, seed, *arguments):
        whole, expected, names = self.seconds_of(inputs, *arguments)
        rng = random.Random(seed)
        for i in range(moments):
            out = self.folder / f"killed-{i}"
            for _ in range(8):
                shutil.rmtree(out, ignore_errors=True)
                code, _ = self.stop_after(whole * rng.uniform(0.02, 0.98), signal.SIGKILL, inputs, out, *arguments)
                if code != 0:
                    break
                whole *= 0.7  # the first run was slower because the machine was busy
            self.assertEqual(code, -signal.SIGKILL, "every run ended before it was killed")
            if out.exists() and i % 2 == 1:  # a second time, while it resumes
                self.stop_after(whole * rng.uniform(0.02, 0.5), signal.SIGKILL, inputs, out, "--resume", *arguments)
            _, run_json = self.work(inputs, "--resume", *arguments, out=out)
            self.assertEqual(run_json["result_hash"], expected)
            self.assertEqual(sorted(p.name for p in out.iterdir()), names)
        return expected

    def times(self, out, *patterns):
        return {p: p.stat().st_mtime_ns for pattern in patterns for p in (out / ".store").glob(pattern)}


class Synthetic(Resume):
    def test_killed_at_random_moments(self):
        self.check_kills(self.district(100000), 4, 11, *SLOW)

    def test_killed_while_making_roofs(self):
        path = self.district(60000)
        self.check_kills(path, 2, 3, *SLOW, "--products", "roofs")
        self.check_kills(path, 2, 4, *SLOW, "--products", "roofs", "--set", "roofs.trust_classes=false")

    def check_kills_of(self, product, path, asked):
        """Kills at random moments, and when the first labels of the product are in the store."""
        expected = self.check_kills(path, 3, 7, *SLOW, *asked)
        out = self.folder / "killed-in-stage"
        code, _ = self.stop_in_stage(product, signal.SIGKILL, path, out, *SLOW, *asked)
        self.assertEqual(code, -signal.SIGKILL)
        _, run_json = self.work(path, "--resume", *SLOW, *asked, out=out)
        self.assertEqual(run_json["result_hash"], expected)

    def test_killed_while_making_facades(self):
        self.check_kills_of("facades", *self.facade(60000))

    def test_killed_while_making_streets(self):
        self.check_kills_of("streets", *self.street(100000))

    def test_killed_with_a_store_elsewhere(self):
        path = self.district(100000)
        self.check_kills(path, 3, 5, *SLOW, "--store", self.folder / "store")
        self.assertFalse((self.folder / "store").exists())

    def test_killed_in_every_stage(self):
        path = self.district(80000)
        _, expected = self.work(path, *SLOW)
        for stage in ("index", "normals", "planes", "join", "label", "write"):
            with self.subTest(stage):
                out = self.folder / stage
                code, _ = self.stop_in_stage(stage, signal.SIGKILL, path, out, *SLOW)
                self.assertEqual(code, -signal.SIGKILL)
                _, run_json = self.work(path, "--resume", *SLOW, out=out)
                self.assertEqual(run_json["result_hash"], expected["result_hash"])

    def test_only_unfinished_work_is_redone(self):
        path = self.district(150000)
        _, expected = self.work(path, *SLOW)
        out = self.folder / "out"
        code, _ = self.stop_in_stage("planes", signal.SIGKILL, path, out, *SLOW)
        self.assertEqual(code, -signal.SIGKILL)
        finished = self.times(out, "blocks/*.codes", "blocks/*.order", "blocks/*.block", "blocks/*.normals", "cells/*.cell",
                              "index", "manifest.json")
        self.assertGreater(len(finished), 60)
        _, run_json = self.work(path, "--resume", "--keep-store", "--threads", "3", "--block-points", "65536", out=out)
        self.assertEqual(run_json["result_hash"], expected["result_hash"])
        self.assertEqual(run_json["blocks"], expected["blocks"], "the first run's partition counts")
        for file, written in finished.items():
            self.assertEqual(file.stat().st_mtime_ns, written, f"{file.name} was written again")
        everything = self.times(out, "blocks/*", "cells/*", "index")
        _, again = self.work(path, "--resume", "--keep-store", *SLOW, out=out)
        self.assertEqual(again["result_hash"], expected["result_hash"])
        self.assertEqual(self.times(out, "blocks/*", "cells/*", "index"), everything)

    def test_finished_runs_of_the_index_are_kept(self):
        path = self.district(300000)
        out = self.folder / "out"
        run = self.start(path, out, *SLOW)
        while run.poll() is None and len(list((out / ".store").glob("runs/*.table"))) < 5:
            time.sleep(0.001)
        run.kill()
        run.communicate()
        runs = len(list((out / ".store").glob("runs/*.table")))
        self.assertGreaterEqual(runs, 5)
        _, run_json = self.work(path, "--resume", *SLOW, out=out)
        self.assertEqual(run_json["result_hash"], self.work(path)[1]["result_hash"])

    def test_interrupted(self):
        path = self.district(80000)
        _, expected = self.work(path, *SLOW)
        for stage, how in (("index", signal.SIGINT), ("normals", signal.SIGTERM), ("planes", signal.SIGINT), ("label", signal.SIGTERM)):
            with self.subTest(stage=stage, how=how.name):
                out = self.folder / f"{stage}-{how.name}"
                code, output = self.stop_in_stage(stage, how, path, out, *SLOW)
                self.assertEqual(code, 130, output)
                lines = [line for line in output.splitlines() if "unit" not in line]
                self.assertEqual(len(lines), 1, output)
                self.assertIn("--resume", lines[0])
                self.assertFalse((out / "run.json").exists())
                _, run_json = self.work(path, "--resume", *SLOW, out=out)
                self.assertEqual(run_json["result_hash"], expected["result_hash"])

    def test_another_request_is_refused(self):
        path, other = self.district(100000), self.district(30000)
        out = self.folder / "out"
        self.stop_in_stage("normals", signal.SIGKILL, path, out, *SLOW)
        for inputs, arguments, word in (([path], ["--set", "planes.epsilon=0.03"], "planes.epsilon"),
                                        ([path], ["--set", "normals.neighbours=9"], "normals.neighbours"),
                                        ([path], ["--bounds", "651000,6861000,651050,6861050"], "area"),
                                        ([path], ["--crs", "EPSG:2154"], "crs"),
                                        ([path, other], [], "inputs")):
            done = ilot("run", *inputs, "-o", out, "-q", "--resume", *SLOW, *arguments)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(f"different: {word}", done.stderr)
        os.utime(path)
        done = ilot("run", path, "-o", out, "-q", "--resume", *SLOW)
        self.assertEqual(done.returncode, 2, "the input was touched")
        _, run_json = self.work(path, "--overwrite", *SLOW, out=out)
        self.assertEqual(run_json["result_hash"], self.work(path)[1]["result_hash"])

    def test_remaining_files_do_no_harm(self):
        path = self.district(60000)
        out, expected = self.work(path, "--keep-store", *SLOW)
        store = out / ".store"
        for file in list(store.glob("blocks/*"))[::3]:  # imitates a removal of the store that was interrupted
            file.unlink()
        (store / "manifest.json").rename(store / "manifest.json.removed")
        _, run_json = self.work(path, "--resume", *SLOW, out=out)
        self.assertEqual(run_json["result_hash"], expected["result_hash"])
        for name in ("manifest.json.77.tmp", "index.77.tmp", "flushed.77.tmp", "scratch-aB3xY7", "blocks/x.codes.part",
                     "runs/y.table.part"):
            (store / name).parent.mkdir(parents=True, exist_ok=True)
            (store / name).write_bytes(b"half")
        (out / ".new" / "points").mkdir(parents=True)
        (out / ".new" / "points" / "half.laz").write_bytes(b"half")
        (out / "run.json.77.tmp").write_bytes(b"half")
        (out / "run.json").unlink()
        _, run_json = self.work(path, "--resume", *SLOW, out=out)
        self.assertEqual(run_json["result_hash"], expected["result_hash"])
        self.assertEqual(sorted(p.name for p in out.iterdir()),
                         ["planes.csv", "planes.gpkg", "planes_neighbours.csv", "points", "run.json"])

    def test_resume_of_nothing_and_of_a_finished_run(self):
        path = self.district(30000)
        out, first = self.work(path, "--resume")
        _, second = self.work(path, "--resume", out=out)
        self.assertEqual(first["result_hash"], second["result_hash"])


class Real(Resume):
    def test_killed_at_random_moments(self):
        inputs = [real("ign/77050_627755_pf6.las"), real("ign/870000_6618000.las")]
        self.check_kills(inputs, 6, 7, "--block-points", "4096")


if __name__ == "__main__":
    main(synthetic=[Synthetic], real=[Real])
