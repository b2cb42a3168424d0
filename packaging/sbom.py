#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the list of parts (SBOM, CycloneDX 1.5 JSON) of programs and libraries on Debian: every shared library that they load, with
the package and the version that it is from, and what is compiled into them. The same files on the same system give the same bytes.

    packaging/sbom.py build/release/tools/ilot build/release/c_api/libilot.so.1 > ilot.cdx.json
"""
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Header-only libraries, compiled in: their packages of Debian.
COMPILED_IN = ("libcli11-dev", "libtomlplusplus-dev", "nlohmann-json3-dev", "libeigen3-dev", "pybind11-dev")


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def libraries_of(path):
    """The real paths of the shared libraries that the file loads. A missing one is a fault."""
    text = output("ldd", path)
    missing = re.findall(r"^\s*(\S+) => not found", text, re.M)
    if missing:
        sys.exit(f"sbom: {path}: needs {', '.join(missing)}, which is not installed")
    return {os.path.realpath(found) for found in re.findall(r"(/\S+) \(0x", text)}


def package_of(library):
    """The package of Debian that a file is from, or None. Files of /lib may be listed as those of /usr/lib and the other way."""
    for name in (library, library.removeprefix("/usr")):
        found = subprocess.run(["dpkg", "-S", name], capture_output=True, text=True)
        if found.returncode == 0:
            return found.stdout.split(":")[0]
    return None


def component(package):
    """A package as CycloneDX has it."""
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Version} ${Architecture}", package], capture_output=True, text=True)
    if done.returncode != 0 or " " not in done.stdout:
        return None
    version, architecture = done.stdout.split()[:2]
    return {"type": "library", "name": package, "version": version,
            "purl": f"pkg:deb/debian/{package}@{version.replace('+', '%2B').replace(':', '%3A')}?arch={architecture}&distro=bookworm"}


def viewer_components():
    """What npm puts into the page of a report."""
    lock = json.loads((ROOT / "viewer/package-lock.json").read_text(encoding="utf-8"))
    for name, entry in sorted(lock["packages"].items()):
        if name and not entry.get("dev"):
            short = name.removeprefix("node_modules/")
            yield {"type": "library", "name": short, "version": entry["version"], "purl": f"pkg:npm/{short}@{entry['version']}"}


def main():
    files = sys.argv[1:]
    if not files:
        sys.exit("sbom: name the programs and libraries (packaging/sbom.py FILE...)")
    libraries = set().union(*(libraries_of(path) for path in files))
    packages = {package_of(library) for library in libraries}
    if None in packages:
        sys.exit("sbom: a library is from no package: " + ", ".join(sorted(x for x in libraries if package_of(x) is None)))
    parts = [component(package) for package in sorted(packages | set(COMPILED_IN))]
    own = [{"type": "file", "name": os.path.basename(path), "hashes": [{
        "alg": "SHA-256", "content": hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()}]} for path in files]
    version = (ROOT / "VERSION").read_text(encoding="utf-8").split()[0]
    bill = {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
            "metadata": {"component": {"type": "application", "name": "ilot", "version": version, "bom-ref": "ilot",
                                       "licenses": [{"license": {"id": "Apache-2.0"}}]}},
            "components": own + [part for part in parts if part] + list(viewer_components())}
    print(json.dumps(bill, indent=1))


if __name__ == "__main__":
    main()
