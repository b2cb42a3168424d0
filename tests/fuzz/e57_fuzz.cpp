// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as an E57 file to the end. The pages get correct checksums first, because otherwise every change
// would be rejected.
#include "engine/formats/e57/e57.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/support/e57_writer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string file = ilot::test::E57Writer::resealed({reinterpret_cast<const char*>(data), size});
  return ilot::fuzz::read_bytes(reinterpret_cast<const std::uint8_t*>(file.data()), file.size(), ".e57",
                                [](auto input) { return ilot::open_e57(std::move(input)); });
}
