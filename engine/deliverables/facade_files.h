// SPDX-License-Identifier: Apache-2.0
// All files that a facade is delivered in.
#pragma once
#include <filesystem>

#include "engine/deliverables/drawing_layers.h"
#include "engine/deliverables/facade_drawing.h"
#include "engine/model/facade.h"

namespace ilot {

struct FacadeFilesParams {
  FacadeDrawingParams drawing;
  DrawingLayers layers = preset_layers("ilot");
};

// "facade-007" for the facade 7: what its files are called before their extensions.
std::string facade_name(std::uint32_t id);

// In `folder`, which exists: facade-NNN.json, .dxf, .svg, .csv, and where an element has a depth .obj and .stl. Each is
// whole or absent. Throws Error.
void write_facade_files(const std::filesystem::path& folder, const Facade& facade,
                        const FacadeFilesParams& params = {});

}  // namespace ilot
