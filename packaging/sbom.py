#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the list of parts (SBOM, CycloneDX 1.5 JSON) of programs and libraries on Debian: every shared library that they load, with
the package and the version that it is from, and what is compiled into them. The same files on the same system give the same bytes.

    packaging/sbom.py build/release/tools/ilot build/release/c_api/libilot.so.1 > ilot.cdx.json
    packaging/sbom.py --gdal PREFIX build/release/tools/ilot > ilot.cdx.json    # of what packaging/tarball.py --gdal PREFIX makes
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Header-only libraries, compiled in: their packages of Debian.
COMPILED_IN = ("libcli11-dev", "libtomlplusplus-dev", "nlohmann-json3-dev", "pybind11-dev")


def output(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, check=True, **options).stdout


def loaded_by(path, gdal=None):
    """What ldd says of the file where libraries below `gdal` (packaging/reduced_gdal.sh) come first."""
    return output("ldd", path, env={**os.environ, **({"LD_LIBRARY_PATH": f"{gdal}/lib"} if gdal else {})})


def libraries_of(path, gdal=None):
    """The real paths of the shared libraries that the file loads. A missing one is a fault."""
    text = loaded_by(path, gdal)
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


def reduced_components(gdal):
    """The libraries that packaging/reduced_gdal.sh has built from Debian's sources."""
    for version in sorted(pathlib.Path(gdal, "share/doc").glob("*/version")):
        yield {"type": "library", "name": f"{version.parent.name}-reduced", "version": version.read_text(encoding="utf-8").strip(),
               "description": "built from Debian's source without its GPL parts"}


def viewer_components():
    """What npm puts into the page of a report."""
    lock = json.loads((ROOT / "viewer/package-lock.json").read_text(encoding="utf-8"))
    for name, entry in sorted(lock["packages"].items()):
        if name and not entry.get("dev"):
            short = name.removeprefix("node_modules/")
            yield {"type": "library", "name": short, "version": entry["version"], "purl": f"pkg:npm/{short}@{entry['version']}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", help="programs and libraries")
    parser.add_argument("--gdal", type=pathlib.Path, help="where packaging/reduced_gdal.sh installed")
    options = parser.parse_args()
    files, gdal = options.files, options.gdal and options.gdal.resolve()
    libraries = {path for file in files for path in libraries_of(file, gdal) if not (gdal and path.startswith(f"{gdal}/"))}
    packages = {package_of(library) for library in libraries}
    if None in packages:
        sys.exit("sbom: a library is from no package: " + ", ".join(sorted(x for x in libraries if package_of(x) is None)))
    parts = [component(package) for package in sorted(packages | set(COMPILED_IN))]
    parts += reduced_components(gdal) if gdal else []
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
