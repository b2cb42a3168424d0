#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Parts of a plan in an object store: GDAL's S3 driver with a small server on the loopback. The bytes of one run, after tasks
that found the store full or gone, with an update whose parts go to another place. tests/full/parts_in_s3.py has a real server."""
import http.server
import json
import os
import subprocess
import threading

from plan_support import PlanTest
from remote import Handler
from support import EXE, Las, ilot, main


class Store(Handler):
    """Takes files, unless `full` says that there is no room."""

    def do_PUT(self):
        body = self.rfile.read(int(self.headers["Content-Length"]))
        self.send_response(507 if self.server.full else 200)
        self.send_header("Content-Length", "0")
        self.end_headers()
        if not self.server.full:
            path = self.server.folder / self.path.lstrip("/")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(body)


class PartsInAStore(PlanTest):
    products = "planes,roofs"

    def setUp(self):
        super().setUp()
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Store)
        self.server.folder, self.server.lock = self.folder, threading.Lock()
        self.server.sent = self.server.fail = self.server.cut = self.server.delay = 0
        self.server.full = False
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)
        settings = {"AWS_S3_ENDPOINT": f"127.0.0.1:{self.server.server_address[1]}", "AWS_HTTPS": "NO",
                    "AWS_VIRTUAL_HOSTING": "FALSE", "AWS_NO_SIGN_REQUEST": "YES", "GDAL_HTTP_MAX_RETRY": "1",
                    "GDAL_HTTP_RETRY_DELAY": "0.05"}
        os.environ.update(settings)
        self.addCleanup(lambda: [os.environ.pop(key) for key in settings])

    def test_same_bytes(self):
        inputs = self.quarters(self.district(60_000))
        one = self.one_run(inputs)
        self.assertGreaterEqual(self.equal(one, inputs, 100, "--parts", "s3://bucket/first"), 4)
        plan, stored = self.folder / "plan-1", self.folder / "bucket/first"
        self.assertEqual([part for part in (plan / "parts").iterdir()], [])
        part = (stored / "1").read_bytes()
        self.assertIn("is done, nothing is left to do", self.task(plan, 1).stderr)
        (stored / "1").unlink()
        self.assertIn("has no part: 1;", ilot("merge", plan, "-o", self.folder / "no").stderr)
        self.server.full = True
        full = self.task(plan, 1)
        self.assertEqual(full.returncode, 75, full.stderr)
        self.assertIn("s3://bucket/first/1: cannot be written", full.stderr)
        self.server.full = False
        (stored / "1").write_bytes(part[:-9])
        (plan / "parts").rmdir()
        (plan / "parts").touch()  # the folder of the plan takes no file
        again = ilot("task", plan, 1, "--work", self.folder / "work")
        self.assertIn("is damaged", again.stderr)
        self.assertEqual((stored / "1").read_bytes(), part)
        self.server.fail = 1000
        gone = ilot("merge", plan, "-o", self.folder / "no")
        self.assertEqual(gone.returncode, 1, gone.stderr)
        self.assertIn("check the address", gone.stderr)
        self.assertEqual(self.task(plan, 1).returncode, 75)

    def test_update_and_make(self):
        self.products = "planes"
        inputs = self.quarters(self.district(30_000))
        plan, what = self.plan(inputs, "--area-size", 33, "--parts", "s3://bucket/first")
        for area in what["areas"]:
            self.assertIn(self.task(plan, area["area"]).returncode, (0, 3))
        las = Las.read(inputs / "0.las")
        las.write(inputs / "0.las", list(las.records())[::2])
        second = self.folder / "second"
        again = ilot("plan", "-o", second, "--update", plan, "--parts", "s3://bucket/first")
        self.assertEqual(again.returncode, 2)
        self.assertIn("has the parts of the other plan", again.stderr)
        updated = ilot("plan", "-o", second, "--update", plan, "--parts", "s3://bucket/second")
        self.assertEqual(updated.returncode, 0, updated.stderr)
        kept = len(list((self.folder / "bucket/second").iterdir()))
        self.assertIn(f"{kept} of {len(what['areas'])} areas keep their part", updated.stderr)
        self.assertGreater(kept, 0)
        (self.folder / "Makefile").write_text(ilot("plan", second, "--as", "make").stdout)
        made = subprocess.run(["make", "-j2", "-s", "-f", self.folder / "Makefile", f"OUT={self.folder}/made", f"ILOT={EXE}"],
                              capture_output=True, text=True, timeout=600)
        self.assertEqual(made.returncode, 0, made.stdout + made.stderr)
        record = json.loads((self.folder / "made/run.json").read_text())
        self.assertEqual(record["result_hash"], self.one_run(inputs)["result_hash"])

    def test_what_is_refused(self):
        cloud = self.district(20_000)
        for url in ("http://127.0.0.1/parts", self.folder / "parts"):
            done = ilot("plan", cloud, "-o", self.folder / "p", "--parts", url)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("must be of an object store", done.stderr)


if __name__ == "__main__":
    main(synthetic=[PartsInAStore])
