// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a text file. The first byte chooses the extension, which decides on counts and intensities.
#include "engine/formats/tables/text.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr const char* kExtensions[] = {".xyz", ".csv", ".pts"};
  return ilot::fuzz::read_bytes(data + 1, size - 1, kExtensions[data[0] % 3],
                                [](auto file) { return ilot::open_text(std::move(file)); });
}
