// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as the truth of a scene.
#include <cstdint>

#include "engine/compare/truth.h"
#include "engine/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    ilot::parse_truth({reinterpret_cast<const char*>(data), size}, "fuzz.truth.json");
  } catch (const ilot::Error&) {
  }
  return 0;
}
