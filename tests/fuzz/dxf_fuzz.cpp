// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a drawing. A drawing that can be read can be validated, and a comparison with itself finds nothing
// to correct.
#include <cstdint>

#include "engine/compare/facades/drawing_control.h"
#include "engine/deliverables/drawings/cad/dxf_reader.h"
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
