// SPDX-License-Identifier: Apache-2.0
// Any bytes as a facade; what is one reads back from what is written of it.
#include <cstdint>

#include "engine/deliverables/facade_json.h"
#include "engine/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  try {
    const Facade facade = parse_facade_json({reinterpret_cast<const char*>(data), size}, "fuzz.json");
    const std::string written = facade_json(facade);
    if (facade_json(parse_facade_json(written, "again.json")) != written) __builtin_trap();
  } catch (const Error&) {
  }
  return 0;
}
