// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a mapping of layers.
#include <cstdint>

#include "engine/deliverables/drawings/drawing_layers.h"
#include "engine/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  try {
    const DrawingLayers layers = parse_layers({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
    for (const DrawingLayer& layer : layers.of_role)
      if (layer.name.empty() || layer.colour < 1 || layer.colour > 255) __builtin_trap();
  } catch (const Error&) {
  }
  return 0;
}
