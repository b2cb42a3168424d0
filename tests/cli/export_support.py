# SPDX-License-Identifier: Apache-2.0
"""What the tests of `ilot export` share."""
import json
import os
import pathlib
import shutil
import subprocess

from support import ilot

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KINDS = ["RoofSurface", "WallSurface", "GroundSurface"]


def npm_has(package):
    npm = os.environ.get("ILOT_NPM")
    return npm and shutil.which("node") and (pathlib.Path(npm) / "node_modules" / package).is_dir()


def must(*arguments, codes=(0,)):
    done = ilot(*arguments)
    if done.returncode not in codes:
        raise AssertionError(f"ilot {arguments}: {done.returncode} {done.stderr}")
    return done


def seen_in_ifc(path):
    done = subprocess.run(["node", ROOT / "tests/oracles/ifc_seen.mjs", path], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)
