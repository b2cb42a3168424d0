// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a PLY file to the end.
#include "engine/formats/tables/ply.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ilot::fuzz::read_bytes(data, size, ".ply", [](auto file) { return ilot::open_ply(std::move(file)); });
}
