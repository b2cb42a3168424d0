// SPDX-License-Identifier: Apache-2.0
// Opens any bytes as a file of the LAS family, reads all points and compares them with the header.
#include "engine/formats/las/las.h"
#include "engine/validity/validate_las.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  const std::string path = fuzz::as_file(data, size, ".las");
  if (path.empty()) return 0;
  try {
    auto input = std::make_unique<InputFile>(path);
    LasContainer container = parse_las(*input);
    if (!container.compressed) validate_las(*open_las(std::move(input), std::move(container)));
  } catch (const Error&) {
  }
  std::remove(path.c_str());
  return 0;
}
