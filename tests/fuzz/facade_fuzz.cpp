// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a facade. A facade that can be read is written and read again, and it is drawn; the drawing is
// read again too.
#include <cstdint>

#include "engine/deliverables/drawings/cad/dxf_reader.h"
#include "engine/deliverables/drawings/cad/dxf_writer.h"
#include "engine/deliverables/drawings/drawing_svg.h"
#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/deliverables/drawings/facade_section.h"
#include "engine/deliverables/solids/facade_solids.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/deliverables/tables/facade_table.h"
#include "engine/error.h"

namespace {

// Throws only Error, for coordinates that no drawing can contain.
void draw(const ilot::Facade& facade) {
  using namespace ilot;
  const DrawingLayers layers = preset_layers("ilot");
  facade_table(facade);
  const auto solids = facade_solids(facade);
  solids_obj(solids);
  solids_stl(solids);
  const Drawing drawing = facade_drawing(facade);
  drawing_svg(drawing, layers);
  if (!parse_dxf(drawing_dxf(drawing, layers), "drawn.dxf").has_end) __builtin_trap();
  drawing_dxf(section_drawing(facade, level_section(facade, 1), facade_faces(facade), {}, ""), layers);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  try {
    const Facade facade = parse_facade_json({reinterpret_cast<const char*>(data), size}, "fuzz.json");
    const std::string written = facade_json(facade);
    if (facade_json(parse_facade_json(written, "again.json")) != written) __builtin_trap();
    draw(facade);
  } catch (const Error&) {
  }
  return 0;
}
