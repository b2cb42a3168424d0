#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Kernels' and engine's tests with asserts (ours and the standard library's) and the sanitizers of addresses and undefined
# behaviour: the preset debug. Most of the time goes into building it.
set -eu
cd "$(dirname "$0")/../.."
cmake --preset debug
cmake --build --preset debug --target kernels_tests engine_tests
ctest --preset debug --parallel "$(nproc)" --no-tests=error -R '^(kernels|engine)_tests/'
