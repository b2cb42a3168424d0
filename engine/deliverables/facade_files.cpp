// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/facade_files.h"

#include <fmt/format.h>

#include "engine/deliverables/drawing_svg.h"
#include "engine/deliverables/dxf_writer.h"
#include "engine/deliverables/facade_json.h"
#include "engine/deliverables/facade_solids.h"
#include "engine/deliverables/facade_table.h"
#include "engine/whole_file.h"

namespace ilot {

std::string facade_name(std::uint32_t id) {
  return fmt::format("facade-{:03}", id);
}

void write_facade_files(const std::filesystem::path& folder, const Facade& facade, const FacadeFilesParams& params) {
  const auto named = [&](const char* extension) { return folder / (facade_name(facade.id) + extension); };
  const Drawing drawing = facade_drawing(facade, params.drawing);
  write_facade_json(named(".json"), facade);
  write_drawing_dxf(named(".dxf"), drawing, params.layers);
  write_drawing_svg(named(".svg"), drawing, params.layers);
  write_whole_file(named(".csv"), facade_table(facade, params.drawing.metres_per_unit));
  const std::vector<FacadeSolid> solids = facade_solids(facade, params.drawing.metres_per_unit);
  if (solids.empty()) return;
  write_whole_file(named(".obj"), solids_obj(solids));
  write_whole_file(named(".stl"), solids_stl(solids));
}

}  // namespace ilot
