#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# clang-tidy (.clang-tidy) over kernels and engine, as compile_commands.json of the preset release tells.
set -eu
cd "$(dirname "$0")/../.."
command -v clang-tidy >/dev/null || { echo "SKIPPED: no clang-tidy"; exit 77; }
cmake --preset release
git ls-files 'kernels/*.cpp' 'engine/*.cpp' 'training/*.cpp' 'scan/*.cpp' |
  xargs -P "$(nproc)" -n 8 clang-tidy -p build/release --quiet --warnings-as-errors='*'
