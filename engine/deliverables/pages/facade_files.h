// SPDX-License-Identifier: Apache-2.0
// All files that a facade is delivered in.
#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "engine/deliverables/drawings/drawing_layers.h"
#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/deliverables/drawings/facade_section.h"
#include "engine/deliverables/drawings/named_sections.h"
#include "engine/deliverables/layers/facade_image.h"
#include "engine/deliverables/pages/facades_page.h"
#include "engine/model/facade.h"

namespace ilot {

struct FacadeFilesParams {
  FacadeDrawingParams drawing;
  DrawingLayers layers = preset_layers("ilot");
  SectionRequests sections;
  double section_half_m = 0.01;  // points so far from a cut are drawn with it
  PointSource points;            // of the facade; without them no image and no points in sections
  FacadeImageParams image;
  FacadesPage* page = nullptr;  // gets the facade too
};

// "facade-007" for the facade 7: what its files are called before their extensions.
std::string facade_name(std::uint32_t id);

// In `folder`, which exists: facade-NNN.json, .dxf, .svg, .pdf, .csv; where an element has a depth .obj and .stl; with
// points .png and .pgw; facade-NNN-SECTION.dxf, .svg and .pdf for each section. Each is whole or absent. The source of
// points is run through four times at most. Throws Error.
void write_facade_files(const std::filesystem::path& folder, const Facade& facade,
                        const FacadeFilesParams& params = {});

}  // namespace ilot
