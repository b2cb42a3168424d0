#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Parts of a plan in an S3 server, npm's s3rver 3.7, on the loopback, in one piece and in pieces of 5 MB: the bytes of one
run. ILOT_EXE is the program; S3RVER is the server, if it is not in PATH."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

PORT, EXE = "14568", os.environ["ILOT_EXE"]


def ilot(*command, code=(0,)):
    done = subprocess.run([EXE, *map(str, command)], capture_output=True, text=True)
    if done.returncode not in code:
        sys.exit(f"{' '.join(map(str, command))}: exit {done.returncode}\n{done.stderr}")
    return done.stderr


def wait_for_server():
    for _ in range(100):
        try:
            urllib.request.urlopen(f"http://127.0.0.1:{PORT}/")
        except urllib.error.HTTPError:
            return
        except OSError:
            time.sleep(0.1)
            continue
        return


def result_of(out):
    return json.loads((out / "run.json").read_text())["result_hash"]


def compare(folder, cloud, chunk):
    os.environ["VSIS3_CHUNK_SIZE"] = str(chunk)
    plan, out = folder / f"plan-{chunk}", folder / f"out-{chunk}"
    ilot("plan", cloud, "-o", plan, "--products", "planes,roofs", "--area-size", "300", "--parts", f"s3://bucket/of/{chunk}", "-q")
    areas = [area["area"] for area in json.loads((plan / "plan.json").read_text())["areas"]]
    for number in areas:
        ilot("task", plan, number, "--threads", "1", "-q", code=(0, 3))
    if "nothing is left to do" not in ilot("task", plan, areas[0], code=(0, 3)):
        sys.exit("a part that is there was made again")
    ilot("merge", plan, "-o", out, "-q", code=(0, 3))
    same = result_of(out) == result_of(folder / "one")
    print(f"{len(areas)} parts in pieces of {chunk} MB: {'the bytes of one run' if same else 'ANOTHER RESULT'}", flush=True)
    return same


def main():
    server = os.environ.get("S3RVER") or shutil.which("s3rver")
    if not server:
        print("not installed: s3rver (npm install s3rver@3.7.1)")
        sys.exit(77)
    os.environ.update({"AWS_S3_ENDPOINT": f"127.0.0.1:{PORT}", "AWS_HTTPS": "NO", "AWS_VIRTUAL_HOSTING": "FALSE",
                       "AWS_ACCESS_KEY_ID": "S3RVER", "AWS_SECRET_ACCESS_KEY": "S3RVER"})
    with tempfile.TemporaryDirectory(prefix="ilot-s3-") as name:
        folder = pathlib.Path(name)
        (folder / "store").mkdir()
        process = subprocess.Popen([server, "-d", folder / "store", "-a", "127.0.0.1", "-p", PORT, "--configure-bucket", "bucket"],
                                   stdout=subprocess.DEVNULL)
        try:
            wait_for_server()
            ilot("scan", "district", "-o", folder / "d.las", "--points", "1000000", "-q")
            ilot("run", folder / "d.las", "-o", folder / "one", "--no-clouds", "--products", "planes,roofs", "-q", code=(0, 3))
            same = [compare(folder, folder / "d.las", chunk) for chunk in (50, 5)]
        finally:
            process.terminate()
            process.wait()
        sys.exit(0 if all(same) else 1)


if __name__ == "__main__":
    main()
