// SPDX-License-Identifier: Apache-2.0
// Any bytes as a drawing; one that can be read can be judged and has nothing to correct beside itself.
#include <cstdint>

#include "engine/compare/drawing_control.h"
#include "engine/deliverables/drawings/dxf_reader.h"
#include "engine/error.h"
#include "engine/validity/validate_drawing.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  try {
    DxfDrawing drawing = parse_dxf({reinterpret_cast<const char*>(data), size}, "fuzz.dxf");
    validate_drawing(drawing);
    drawing.units = 6;
    for (const LayerControl& layer : compare_drawings(drawing, drawing))
      if (layer.missed + layer.removed + layer.moved != 0) __builtin_trap();
  } catch (const Error&) {
  }
  return 0;
}
