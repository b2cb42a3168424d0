#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh SECONDS [TARGET...]: builds the fuzz targets in build/fuzz with clang, ASan and UBSan, makes their corpus and
# runs each for so many seconds. Inputs that crash stay in build/fuzz/crashes/; exit 1 when there are any. ILOT_EXE names
# the ilot that makes the seeds; without it one is built in the same way.
set -eu
[ $# -ge 1 ] || { echo "usage: $0 SECONDS [TARGET...]" >&2; exit 2; }
seconds=$1
shift
cd "$(dirname "$0")/../.."
build=$PWD/build/fuzz
cmake -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DILOT_SANITIZE=fuzzer-no-link,address,undefined >/dev/null
cmake --build "$build" --target fuzzers
if [ -z "${ILOT_EXE:-}" ]; then
  cmake --build "$build" --target ilot
  ILOT_EXE=$build/tools/ilot
fi
export ILOT_EXE
rm -rf "$build/seeds"
python3 tests/fuzz/corpus.py "$build/seeds"
mkdir -p "$build/crashes"
status=0
for target in ${*:-$(ls "$build/seeds")}; do
  mkdir -p "$build/corpus/$target" "$build/seeds/$target"
  echo "$target: $seconds s"
  UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 "$build/tests/fuzz/$target" -max_total_time="$seconds" -timeout=20 \
    -rss_limit_mb=3000 -max_len=65536 -print_final_stats=1 -artifact_prefix="$build/crashes/$target-" \
    "$build/corpus/$target" "$build/seeds/$target" >"$build/$target.log" 2>&1 || status=1
  grep -E '^SUMMARY|executed_units|Test unit written' "$build/$target.log" || true
done
exit $status
