#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the Debian packages of the last commit twice, each from a clean clone: in folders of different depth, with another umask,
time zone, locale, home, number of jobs, at another time. Every .deb must have the same bytes; where one differs, its members that do are
named. The packages are left in build/full/reproducible. ILOT_DEB_CACHE names a folder for compiler caches, one for each of the
two builds, so that no object of one is taken for the other; without it nothing is cached. Skipped without dpkg-buildpackage."""
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BUILDS = {
    "one": {"under": "one/ilot", "umask": 0o022, "TZ": "UTC", "LC_ALL": "C.UTF-8", "HOME": "/nonexistent", "jobs": 2},
    "two": {"under": "two/of/another/depth/sources", "umask": 0o027, "TZ": "Asia/Tokyo", "LC_ALL": "C", "HOME": "/tmp", "jobs": 3},
}


def built(place, name, how):
    """Returns the packages by name."""
    sources = place / how["under"]
    for old in sources.parent.glob("*.deb"):
        old.unlink()
    if not sources.exists():
        subprocess.run(["git", "clone", "-q", "--no-hardlinks", ROOT, sources], check=True)
    head = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    subprocess.run(["git", "fetch", "-q", "origin"], cwd=sources, check=True)
    subprocess.run(["git", "checkout", "-q", "--detach", head], cwd=sources, check=True)
    subprocess.run(["git", "clean", "-qffdx"], cwd=sources, check=True)
    if (ROOT / "viewer/node_modules").is_dir():
        shutil.copytree(ROOT / "viewer/node_modules", sources / "viewer/node_modules", symlinks=True)
    env = {k: v for k, v in os.environ.items() if not k.startswith(("LC_", "LANG", "CCACHE_", "DEB_", "CMAKE_"))}
    env.update({k: how[k] for k in ("TZ", "LC_ALL", "HOME")}, DEB_BUILD_OPTIONS=f"parallel={how['jobs']}")
    if cache := os.environ.get("ILOT_DEB_CACHE"):
        env.update(CMAKE_CXX_COMPILER_LAUNCHER="ccache", CCACHE_DIR=str(pathlib.Path(cache) / name), CCACHE_SLOPPINESS="pch_defines,time_macros")
    with open(place / f"{name}.log", "w", encoding="utf-8") as log:
        done = subprocess.run(["dpkg-buildpackage", "-b", "-us", "-uc"], cwd=sources, env=env, umask=how["umask"], stdout=log, stderr=log)
    if done.returncode != 0:
        sys.exit(f"dpkg-buildpackage ended with {done.returncode}: see {place}/{name}.log")
    return {p.name: p for p in sources.parent.glob("*.deb")}


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def members(package):
    """Digests of all that is in a package, with modes and times as tar lists them."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["dpkg-deb", "-R", package, folder], check=True)
        found = {str(p.relative_to(folder)): digest(p) for p in pathlib.Path(folder).rglob("*") if p.is_file() and not p.is_symlink()}
    listed = subprocess.run(["dpkg-deb", "-c", package], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
    return found | {"listed " + line.split()[5]: line for line in listed}


def main():
    if not shutil.which("dpkg-buildpackage"):
        print("SKIPPED: no dpkg-buildpackage")
        return 77
    place = ROOT / "build/full/reproducible"
    place.mkdir(parents=True, exist_ok=True)
    one, two = [built(place, name, how) for name, how in BUILDS.items()]
    if not one or one.keys() != two.keys():
        sys.exit(f"the builds made {sorted(one)} and {sorted(two)}")
    differ = 0
    for name, path in sorted(one.items()):
        same = digest(path) == digest(two[name])
        differ += not same
        print(f"{digest(path)}  {name}" if same else f"{name} differs")
        if not same:
            left, right = members(path), members(two[name])
            for member in sorted(left.keys() | right.keys()):
                if left.get(member) != right.get(member):
                    print(f"  {member}: {left.get(member)} {right.get(member)}")
    if differ:
        sys.exit(f"{differ} of {len(one)} packages differ")
    print(f"{len(one)} packages, twice the same bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
