#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Debian's control file and the recipes for vcpkg and conda name every library that CMake or an include asks for, and no other. It
reads them only: neither vcpkg nor conda is needed."""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What sources ask for: (find_package or the beginning of an include, Debian, vcpkg, conda).
LIBRARIES = (
    ("CLI11", "libcli11-dev", "cli11", "cli11"),
    ("embree", "libembree-dev", "embree3", "embree"),
    ("fmt", "libfmt-dev", "fmt", "fmt"),
    ("GDAL", "libgdal-dev", "gdal", "libgdal-core"),
    ("GEOS", "libgeos-dev", "geos", "geos"),
    ("nlohmann_json", "nlohmann-json3-dev", "nlohmann-json", "nlohmann_json"),
    ("OpenSSL", "libssl-dev", "openssl", "openssl"),
    ("PNG", "libpng-dev", "libpng", "libpng"),
    ("PROJ", "libproj-dev", "proj", "proj"),
    ("pugixml", "libpugixml-dev", "pugixml", "pugixml"),
    ("libsvm/", "libsvm-dev", "libsvm", "libsvm"),
    ("TBB", "libtbb-dev", "tbb", "tbb-devel"),
    ("toml++/", "libtomlplusplus-dev", "tomlplusplus", "tomlplusplus"),
    ("ZLIB", "zlib1g-dev", "zlib", "zlib"),
)
PYTHON = {"pybind11", "python", "numpy"}  # conda's alone: the others build the package for Python where they find it
TOOLS = {"debhelper-compat", "cmake", "dh-python", "ninja-build", "python3-dev", "python3-numpy", "pybind11-dev"}
BUILT = ("kernels", "engine", "tools", "scan", "training", "python", "c_api")


def asked():
    """Names of packages and includes in what a release builds."""
    names = set()
    for name in subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True).stdout.splitlines() or \
            [p.relative_to(ROOT).as_posix() for top in BUILT for p in (ROOT / top).rglob("*")]:
        if name.split("/")[0] not in BUILT or not name.endswith(("CMakeLists.txt", ".cpp", ".h", ".inl")):
            continue
        text = (ROOT / name).read_text(encoding="utf-8")
        if name.endswith("CMakeLists.txt"):
            names |= set(re.findall(r"find_package\((\w+)[^)]*REQUIRED", text))
        else:
            names |= set(re.findall(r"#include <(toml\+\+/|libsvm/|Eigen/)", text))
    return names - {"Threads"}


def compare(what, found, expected):
    if found != expected:
        sys.exit(f"recipes: {what}: too many {sorted(found - expected)}, missing {sorted(expected - found)}")


def main():
    compare("the table of this test", {row[0] for row in LIBRARIES}, asked())
    control = (ROOT / "debian/control").read_text(encoding="utf-8")
    build = re.search(r"^Build-Depends: (.*?)\n\n", control, re.M | re.S).group(1)
    compare("debian/control", {word.split()[0] for word in build.split(",")} - TOOLS, {row[1] for row in LIBRARIES})
    port = json.loads((ROOT / "packaging/vcpkg/ilot/vcpkg.json").read_text(encoding="utf-8"))
    named = [d if isinstance(d, str) else d["name"] for d in port["dependencies"]]
    compare("vcpkg.json", {n for n in named if not n.startswith("vcpkg-")}, {row[2] for row in LIBRARIES})
    recipe = (ROOT / "packaging/conda/meta.yaml").read_text(encoding="utf-8")
    host = re.search(r"^  host:\n((?:    - .*\n)+)", recipe, re.M).group(1)
    compare("meta.yaml", {line.split()[1] for line in host.splitlines()} - PYTHON, {row[3] for row in LIBRARIES})
    version = (ROOT / "VERSION").read_text(encoding="utf-8").split()[0]
    for name, text in (("vcpkg.json", port["version"]), ("meta.yaml", re.search(r'version: "(.*)"', recipe).group(1)),
                       ("DESCRIPTION of R", re.search(r"^Version: (.*)$", (ROOT / "r/ilot/DESCRIPTION").read_text(), re.M).group(1))):
        if text != version:
            sys.exit(f"recipes: {name} has version {text}, VERSION has {version}")


if __name__ == "__main__":
    main()
