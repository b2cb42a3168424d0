// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a PCD file to the end.
#include "engine/formats/tables/pcd.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ilot::fuzz::read_bytes(data, size, ".pcd", [](auto file) { return ilot::open_pcd(std::move(file)); });
}
