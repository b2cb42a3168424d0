#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The thread sanitizer on the kernels' tests and on those of passes, the store and tiles: the preset tsan.
set -eu
cd "$(dirname "$0")/../.."
cmake --preset tsan
cmake --build --preset tsan --target kernels_tests engine_tests
TSAN_OPTIONS="suppressions=$PWD/tests/full/tsan_suppressions.txt ${TSAN_OPTIONS:-}"
export TSAN_OPTIONS
ctest --test-dir build/tsan --output-on-failure --parallel "$(nproc)" --no-tests=error \
  -R '^(kernels_tests/|engine_tests/(Pass|Index|Store|Tile|Packed|Raster|Column|Join|Cells|Planes))'
