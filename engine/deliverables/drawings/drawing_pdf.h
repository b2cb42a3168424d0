// SPDX-License-Identifier: Apache-2.0
// A drawing as PDF 1.5: one page of paper at the scale of the drawing, with vectors and one layer for each layer of the
// drawing, which a reader can switch (pdf_file.h).
#pragma once
#include <filesystem>
#include <string>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

// Pens, colours and texts are those of drawing_svg(). Texts are in Helvetica, which every reader has; letters that are
// not Western European become "?". Layers that are not shown are written, but switched off. There are no time stamps:
// the same drawing gives the same bytes.
std::string drawing_pdf(const Drawing& drawing, const DrawingLayers& layers);
void write_drawing_pdf(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers);

}  // namespace ilot
