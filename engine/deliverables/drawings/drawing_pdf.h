// SPDX-License-Identifier: Apache-2.0
// A drawing as PDF 1.5: one page of paper at its scale, vectors, a layer each of the drawing's to switch.
//
// Why a writer of our own: what it takes is a page of path operators; the library at hand for it (cairo) stamps files
// with the time and knows no layers.
#pragma once
#include <filesystem>
#include <string>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

// Pens, colours and texts as in drawing_svg(); texts in Helvetica, which every reader has: letters beyond Western
// Europe's become "?". Layers that are not shown are there, and off. No time stamps: the same drawing gives the same
// bytes.
std::string drawing_pdf(const Drawing& drawing, const DrawingLayers& layers);
void write_drawing_pdf(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers);

}  // namespace ilot
