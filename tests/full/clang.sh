#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The other compiler: Clang builds everything without a warning, and the kernels' and engine's tests pass.
set -eu
cd "$(dirname "$0")/../.."
command -v clang++ >/dev/null || { echo "SKIPPED: no clang++"; exit 77; }
cmake --preset dev -B build/clang -DCMAKE_CXX_COMPILER=clang++
cmake --build build/clang
ctest --test-dir build/clang --output-on-failure --parallel "$(nproc)" --no-tests=error -R '^(kernels|engine)_tests/'
