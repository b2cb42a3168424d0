#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a tarball of ilot that runs from any folder on Linux with the same glibc or a newer one: the program, the shared libraries
that it loads (those of glibc are the system's), data of GDAL and PROJ, and a start that finds them. The same files give the same bytes.

    packaging/reduced_gdal.sh build/gdal
    packaging/tarball.py build/release/tools/ilot ilot-0.1.0-linux-amd64.tar.gz --gdal build/gdal
"""
import argparse
import gzip
import io
import os
import pathlib
import re
import sys
import tarfile

from sbom import ROOT, libraries_of, loaded_by, package_of

# They belong to the system: their parts must be of one version with the loader.
GLIBC = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|anl|nsl|mvec|BrokenLocale|nss_\w+|thread_db))[.-]")
# Packages below Debian's libgdal and libtiff that are under the GPL alone, by their copyright files of Debian 12.
GPL = {"libjbig0", "libpoppler126", "librttopo1", "libx265-199"}
DATA = {"gdal": "/usr/share/gdal", "proj": "/usr/share/proj"}
START = """#!/bin/sh
# Starts ilot with the libraries and the data that lie beside it.
here=$(dirname "$(readlink -f "$0")")
export GDAL_DATA="$here/../share/gdal" PROJ_LIB="$here/../share/proj" GDAL_DRIVER_PATH=disable
# By the loader's own option, so that programs that ilot starts (a browser) do not take these libraries.
exec /lib64/ld-linux-x86-64.so.2 --library-path "$here/../lib/ilot" --argv0 "$0" "$here/../lib/ilot/ilot" "$@"
"""


def names_of(program, gdal):
    """The name by which each library is looked up -> its file."""
    known = libraries_of(program, gdal)  # refuses a program with a missing library
    names = dict(re.findall(r"^\s*(\S+) => (/\S+) \(0x", loaded_by(program, gdal), re.M))
    assert all(os.path.realpath(path) in known for path in names.values())
    return {name: os.path.realpath(path) for name, path in sorted(names.items()) if not GLIBC.match(name)}


def members(program, libraries, gdal):
    """(path in the tarball, bytes, mode), sorted by path."""
    found = [("bin/ilot", START.encode(), 0o755), ("lib/ilot/ilot", pathlib.Path(program).read_bytes(), 0o755)]
    found += [(f"lib/ilot/{name}", pathlib.Path(path).read_bytes(), 0o644) for name, path in libraries.items()]
    for name, folder in {**DATA, **({"gdal": f"{gdal}/share/gdal"} if gdal else {})}.items():
        found += [(f"share/{name}/{p.relative_to(folder)}", p.read_bytes(), 0o644) for p in pathlib.Path(folder).rglob("*") if p.is_file()]
    for package in sorted({package_of(path) for path in libraries.values()} - {None}):
        found.append((f"share/doc/{package}/copyright", pathlib.Path("/usr/share/doc", package, "copyright").read_bytes(), 0o644))
    for copyright in pathlib.Path(gdal, "share/doc").glob("*/copyright") if gdal else ():
        found.append((f"share/doc/{copyright.parent.name}-reduced/copyright", copyright.read_bytes(), 0o644))
    found.append(("share/doc/ilot/LICENSE", (ROOT / "LICENSE").read_bytes(), 0o644))
    found.append(("share/doc/ilot/copyright", (ROOT / "debian/copyright").read_bytes(), 0o644))
    return sorted(found)


def write(path, folder, files):
    """Whole or not at all; neither times nor owners of this machine are in it."""
    new = path.with_name(path.name + ".tmp")
    with new.open("wb") as raw, gzip.GzipFile("", "wb", 6, raw, 0) as packed, tarfile.open(fileobj=packed, mode="w") as tar:
        for name, data, mode in files:
            entry = tarfile.TarInfo(f"{folder}/{name}")
            entry.size, entry.mode, entry.mtime = len(data), mode, int(os.environ.get("SOURCE_DATE_EPOCH", 0))
            tar.addfile(entry, io.BytesIO(data))
    new.rename(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("tarball", type=pathlib.Path)
    parser.add_argument("--with-gpl", action="store_true", help="put in libraries that are under the GPL alone; pass the tarball on under its terms")
    parser.add_argument("--gdal", type=pathlib.Path, help="take the libgdal and libtiff that packaging/reduced_gdal.sh installed there")
    options = parser.parse_args()
    gdal = options.gdal and options.gdal.resolve()
    if gdal and not (gdal / "lib/libgdal.so").exists():
        sys.exit(f"tarball: {gdal}/lib/libgdal.so: no such file; make it by packaging/reduced_gdal.sh {gdal}")
    if not options.program.is_file():
        sys.exit(f"tarball: {options.program}: no such file; build it by cmake --build --preset release --target ilot")
    libraries = names_of(options.program, gdal)
    gpl = sorted(GPL & {package_of(path) for path in libraries.values()})
    if gpl and not options.with_gpl:
        sys.exit(f"tarball: the program loads {', '.join(gpl)}, which are under the GPL; give --gdal (packaging/reduced_gdal.sh), or --with-gpl")
    files = members(options.program, libraries, gdal)
    write(options.tarball, options.tarball.name.removesuffix(".tar.gz"), files)
    print(f"{options.tarball}: {len(libraries)} libraries, {sum(len(data) for _, data, _ in files) / 1e6:.0f} MB unpacked, "
          f"{options.tarball.stat().st_size / 1e6:.0f} MB packed")


if __name__ == "__main__":
    main()
