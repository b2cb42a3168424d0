#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# clang-tidy (.clang-tidy) over kernels, engine, training and scan, each file alone, as Clang would compile it.
set -eu
cd "$(dirname "$0")/../.."
command -v clang-tidy >/dev/null || { echo "SKIPPED: no clang-tidy"; exit 77; }
cmake --preset plain -B build/tidy -DCMAKE_CXX_COMPILER=clang++
git ls-files 'kernels/*.cpp' 'engine/*.cpp' 'training/*.cpp' 'scan/*.cpp' |
  xargs -P "$(nproc)" -n 8 clang-tidy -p build/tidy --quiet --warnings-as-errors='*'
