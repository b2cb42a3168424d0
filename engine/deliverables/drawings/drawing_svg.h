// SPDX-License-Identifier: Apache-2.0
// A drawing as SVG: a sheet of paper at its scale. One unit is a millimetre, one group is a layer.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

// An image under the lines: a link relative to the SVG, and the place of the image in the drawing.
struct SvgUnderlay {
  std::string link;
  FlatBox place;
};

// A stretch of a line with a note. The note is a title that is shown when the pointer is on the stretch; it is in a
// group above everything else. The stretch is invisible unless the page gives its class ("note-KIND") a stroke.
struct SvgNote {
  DrawingCorner from, to;
  std::string kind, text;
  int worth = 0;  // order for sorting; later notes are above earlier ones
};

enum class SvgPart : std::uint8_t { sheet, plan };  // sheet: everything; plan: without frame and title, cut to the rest

// Pens have the width on paper that their layers give, colours are those on white paper. Layers that are not shown have
// display:none. Classes are names of roles ("role-opening"). The same drawing gives the same bytes.
std::string drawing_svg(const Drawing& drawing, const DrawingLayers& layers, SvgPart part = SvgPart::sheet,
                        const std::optional<SvgUnderlay>& underlay = {}, std::span<const SvgNote> notes = {});
void write_drawing_svg(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers);

}  // namespace ilot
