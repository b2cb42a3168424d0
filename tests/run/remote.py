#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Inputs by URL, from a server on the loopback: the bytes of a run over the same files on disk, a plan and its tasks, few
bytes for a small area, a server that is slow, cuts answers, fails for a while, or is gone, and names of an S3 store."""
import http.server
import json
import os
import re
import threading
import time

from support import Las, RunTest, ilot, main

os.environ["GDAL_HTTP_RETRY_DELAY"] = "0.05"


class Handler(http.server.BaseHTTPRequestHandler):
    """Files by ranges. The server says how it misbehaves: `delay` seconds, `cut` and `fail` for so many answers."""

    protocol_version = "HTTP/1.1"

    def answer(self, body):
        server = self.server
        with server.lock:
            fail, cut = server.fail > 0, server.cut > 0 and body
            server.fail -= fail
            server.cut -= cut
        time.sleep(server.delay)
        path = server.folder / self.path.lstrip("/")
        if fail or not path.is_file():
            self.send_response(503 if fail else 404)
            self.send_header("Content-Length", "0")
            self.end_headers()
            return
        data = path.read_bytes()
        wanted = re.match(r"bytes=(\d+)-(\d*)$", self.headers.get("Range", ""))
        first, last = (int(wanted[1]), min(int(wanted[2] or len(data) - 1), len(data) - 1)) if wanted else (0, len(data) - 1)
        part = data[first:last + 1]
        self.send_response(206 if wanted else 200)
        self.send_header("Content-Length", str(len(part)))
        self.send_header("Accept-Ranges", "bytes")
        if wanted:
            self.send_header("Content-Range", f"bytes {first}-{last}/{len(data)}")
        self.end_headers()
        if not body:
            return
        part = part[:len(part) // 2] if cut else part
        self.close_connection = bool(cut)
        try:
            self.wfile.write(part)
        except OSError:
            return  # the client had enough
        with server.lock:
            server.sent += len(part)

    def do_GET(self):
        self.answer(True)

    def do_HEAD(self):
        self.answer(False)

    def log_message(self, *_):
        pass


class Remote(RunTest):
    def setUp(self):
        super().setUp()
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.folder, self.server.lock = self.folder, threading.Lock()
        self.server.sent = self.server.fail = self.server.cut = self.server.delay = 0
        self.port = self.server.server_address[1]
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)
        cloud = self.district(100_000)
        for name in ("one.laz", "one.copc.laz"):
            self.assertEqual(ilot("convert", cloud, self.folder / name).returncode, 0)

    def url(self, name):
        return f"http://127.0.0.1:{self.port}/{name}"

    def run_hash(self, out, *command):
        done = ilot("run", *command, "-o", self.folder / out, "--no-report")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / out / "run.json").read_text())["result_hash"]

    def test_same_bytes(self):
        for name in ("one.laz", "one.copc.laz"):
            self.assertEqual(self.run_hash(f"web-{name}", self.url(name)), self.run_hash(f"disk-{name}", self.folder / name), name)
        info = ilot("info", self.url("one.copc.laz"))
        self.assertIn("laz 1.4", info.stdout)

    def test_a_server_with_faults(self):
        self.server.delay, self.server.fail = 0.002, 2
        self.assertEqual(self.run_hash("web", self.url("one.laz")), self.run_hash("disk", self.folder / "one.laz"))
        self.assertEqual(self.server.fail, 0)
        self.server.cut = 1000
        cut = ilot("run", self.url("one.copc.laz"), "-o", self.folder / "cut")
        self.assertEqual(cut.returncode, 1, cut.stderr)
        self.assertFalse((self.folder / "cut/run.json").exists())

    def test_an_area_of_a_large_file(self):
        """Nodes of an octree that the area does not need are not fetched."""
        cloud, name = self.scan("district", 2_000_000, self.folder / "large.las"), "large.copc.laz"
        self.assertEqual(ilot("convert", cloud, self.folder / name).returncode, 0)
        points = Las.read(cloud).points()
        x, y = min(p[0] for p in points), min(p[1] for p in points)
        area = ("--bounds", f"{x + 20},{y + 20},{x + 60},{y + 60}", "--no-clouds")
        self.server.sent = 0
        web = self.run_hash("web", self.url(name), *area)
        self.assertLess(self.server.sent, (self.folder / name).stat().st_size * 2 / 3)
        self.assertEqual(web, self.run_hash("disk", self.folder / name, *area))

    def test_plan_and_tasks(self):
        plan = self.folder / "plan"
        planned = ilot("plan", self.url("one.laz"), "-o", plan, "--products", "planes", "--area-size", 40)
        self.assertEqual(planned.returncode, 0, planned.stderr)
        areas = json.loads((plan / "plan.json").read_text())["areas"]
        self.assertGreater(len(areas), 1)
        for area in areas:
            self.assertEqual(ilot("task", plan, area["area"], "--threads", "1").returncode, 0)
        (plan / "parts/1").unlink()
        self.server.fail = 1000
        self.assertEqual(ilot("task", plan, 1).returncode, 75, "a server that fails may answer later")
        self.server.fail = 0
        self.assertEqual(ilot("task", plan, 1).returncode, 0)
        merged = ilot("merge", plan, "-o", self.folder / "merged", "--no-report")
        self.assertEqual(merged.returncode, 0, merged.stderr)
        one = self.run_hash("one", self.folder / "one.laz", "--products", "planes", "--no-clouds")
        self.assertEqual(json.loads((self.folder / "merged/run.json").read_text())["result_hash"], one)

    def test_what_is_not_there(self):
        done = ilot("run", self.url("none.laz"), "-o", self.folder / "out")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("cannot be opened", done.stderr)
        self.assertFalse((self.folder / "out/run.json").exists())

    def test_names_of_an_object_store(self):
        """GDAL's S3 driver, asked to use the server on the loopback without a signature: bucket and key are its folders."""
        (self.folder / "bucket/tiles").mkdir(parents=True)
        (self.folder / "one.copc.laz").rename(self.folder / "bucket/tiles/a.copc.laz")
        settings = {"AWS_S3_ENDPOINT": f"127.0.0.1:{self.port}", "AWS_HTTPS": "NO", "AWS_VIRTUAL_HOSTING": "FALSE",
                    "AWS_NO_SIGN_REQUEST": "YES"}
        os.environ.update(settings)
        self.addCleanup(lambda: [os.environ.pop(key) for key in settings])
        self.assertEqual(self.run_hash("s3", "s3://bucket/tiles/a.copc.laz", "--no-clouds"),
                         self.run_hash("disk", self.folder / "bucket/tiles/a.copc.laz", "--no-clouds"))


if __name__ == "__main__":
    main(synthetic=[Remote])
