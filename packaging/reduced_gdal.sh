#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Builds libgdal and libtiff from Debian's own sources with what ilot uses and nothing under the GPL:
#   packaging/reduced_gdal.sh PREFIX
# Drivers: GTiff, COG, PNG, JPEG, VRT, MEM; GeoPackage, SQLite, Shapefile, GeoJSON, FlatGeobuf, DXF, CSV, KML, TAB; network by
# curl. Both have the names, the versions and the interface of Debian's libraries (libgdal.so.32, libtiff.so.6), so that a
# program that was linked with Debian's can load these instead: packaging/tarball.py --gdal PREFIX. Debian's libgdal
# loads poppler, x265 and librttopo, and its libtiff loads jbigkit: all four are under the GPL.
# Needs what tools/setup installs. About ten minutes of one processor.
set -euo pipefail
prefix="$(realpath -m "${1:?reduced_gdal.sh: name the folder to install into}")"
jobs="${JOBS:-$(nproc)}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# Sources of the versions that Debian 12 has now, whether or not this system lists sources.
mkdir -p "$work/lists/partial"
key="signed-by=/usr/share/keyrings/debian-archive-keyring.gpg"
printf '%s\n' "deb-src [$key] http://deb.debian.org/debian bookworm main" \
  "deb-src [$key] http://deb.debian.org/debian-security bookworm-security main" > "$work/sources.list"
apt=(-o "Dir::Etc::sourcelist=$work/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$work/lists"
     -o APT::Sandbox::User=root -o "Dir::Cache::srcpkgcache=" -o "Dir::Cache::pkgcache=")
cd "$work"
apt-get "${apt[@]}" -qq update
apt-get "${apt[@]}" -qq --download-only source tiff gdal
for description in *.dsc; do dpkg-source --no-check -x "$description" "${description%%_*}" > /dev/null; done

# Where files were built must not be seen in them, so that two builds have the same bytes.
export CFLAGS="-O2 -ffile-prefix-map=$work=." CXXFLAGS="-O2 -ffile-prefix-map=$work=."
SOURCE_DATE_EPOCH="$(cd gdal && dpkg-parsechangelog -STimestamp)"
export SOURCE_DATE_EPOCH

build() {  # SOURCE OPTION...
  local name="$1"
  shift
  cmake -S "$name" -B "build-$name" -G Ninja -Wno-dev -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_PREFIX_PATH="$prefix" -DBUILD_SHARED_LIBS=ON "$@" > "$name.log" 2>&1 \
    && cmake --build "build-$name" -j "$jobs" >> "$name.log" 2>&1 \
    && cmake --install "build-$name" --strip >> "$name.log" 2>&1 || { tail -n 40 "$name.log" >&2; exit 1; }
  # The licence goes where the tarball looks for it.
  install -D -m 644 "$name/debian/copyright" "$prefix/share/doc/$name/copyright"
  (cd "$name" && dpkg-parsechangelog -SVersion) > "$prefix/share/doc/$name/version"
}

build tiff -Dld-version-script=ON -Djbig=OFF -Dwebp=OFF -Dlerc=OFF -Dtiff-tools=OFF -Dtiff-tests=OFF -Dtiff-contrib=OFF \
  -Dtiff-docs=OFF -Dcxx=OFF

drivers=()
for name in SQLITE GPKG FLATGEOBUF DXF CSV; do drivers+=("-DOGR_ENABLE_DRIVER_$name=ON"); done
for name in PNG JPEG; do drivers+=("-DGDAL_ENABLE_DRIVER_$name=ON"); done
libraries=()
for name in CURL DEFLATE EXPAT GEOS JPEG LIBLZMA PNG SQLITE3 TIFF ZLIB ZSTD; do libraries+=("-DGDAL_USE_$name=ON"); done
for name in GEOTIFF JSONC; do libraries+=("-DGDAL_USE_${name}_INTERNAL=ON"); done
build gdal -DBUILD_APPS=OFF -DBUILD_TESTING=OFF -DBUILD_PYTHON_BINDINGS=OFF -DBUILD_JAVA_BINDINGS=OFF \
  -DBUILD_CSHARP_BINDINGS=OFF -DGDAL_USE_EXTERNAL_LIBS=OFF -DGDAL_USE_INTERNAL_LIBS=OFF -DGDAL_BUILD_OPTIONAL_DRIVERS=OFF \
  -DOGR_BUILD_OPTIONAL_DRIVERS=OFF -DGDAL_SET_INSTALL_RELATIVE_RPATH=ON "${drivers[@]}" "${libraries[@]}"
echo "$prefix: libgdal $(cat gdal/VERSION), $(du -sh "$prefix/lib" | cut -f1)"
