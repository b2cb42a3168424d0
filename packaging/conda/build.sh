#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Called by conda build: PREFIX, SP_DIR and PYTHON are its.
set -euo pipefail
cmake -S . -B build/conda -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" \
  -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_PREFIX_PATH="$PREFIX" -DILOT_BUILD_TESTS=OFF -DILOT_JOIN_FILES=ON \
  -DILOT_PYTHON_EXECUTABLE="$PYTHON" -DILOT_PYTHON_INSTALL="${SP_DIR#"$PREFIX"/}"
cmake --build build/conda
cmake --install build/conda
