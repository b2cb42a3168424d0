#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every file of ilot compiles alone, without precompiled headers: it includes what it uses.
set -eu
cd "$(dirname "$0")/../.."
cmake --preset plain
cmake --build --preset plain
