// SPDX-License-Identifier: Apache-2.0
// All files in which a facade is delivered.
#pragma once
#include <filesystem>
#include <functional>
#include <span>
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
  double section_half_m = 0.01;  // points at most this far from a section are drawn with it
  PointSource points;            // of the facade; without it there is no image and sections have no points
  FacadeImageParams image;
  FacadesPage* page = nullptr;  // the facade is added to this page too
};

// Returns "facade-007" for facade 7: the name of its files without their extensions.
std::string facade_name(std::uint32_t id);

// Writes row-NNN.dxf, .svg and .pdf: the houses of a row on one sheet (row_drawing).
void write_row_files(const std::filesystem::path& folder, std::uint32_t row, std::span<const Facade> houses,
                     const FacadeFilesParams& params = {});

// Writes to `folder`, which exists: facade-NNN.json, .dxf, .svg, .pdf, .csv; when an element has a depth, .obj and
// .stl; with points, .png and .pgw; facade-NNN-SECTION.dxf, .svg and .pdf for each section. Each file is complete or
// absent. The source of points is read four times at most. Throws Error.
void write_facade_files(const std::filesystem::path& folder, const Facade& facade,
                        const FacadeFilesParams& params = {});

}  // namespace ilot
