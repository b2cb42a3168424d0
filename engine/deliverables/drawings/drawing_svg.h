// SPDX-License-Identifier: Apache-2.0
// A drawing as SVG: a sheet of paper at its scale, a unit a millimetre, a group a layer.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

// An image under the lines: a link, relative to the SVG, and where it lies in the drawing.
struct SvgUnderlay {
  std::string link;
  FlatBox place;
};

// A stretch of a line that has something to tell: a title to be read where the pointer is, in a group over everything.
// It is not drawn but for a page that gives its class ("note-KIND") a stroke.
struct SvgNote {
  DrawingCorner from, to;
  std::string kind, text;
  int worth = 0;  // for who sorts them: later ones lie above
};

enum class SvgPart : std::uint8_t { sheet, plan };  // all of it, or without frame and title, cut to the rest

// Pens are as wide on paper as their layers say, colours those on white paper; layers that are not shown have
// display:none. Classes are names of roles ("role-opening"). The same drawing gives the same bytes.
std::string drawing_svg(const Drawing& drawing, const DrawingLayers& layers, SvgPart part = SvgPart::sheet,
                        const std::optional<SvgUnderlay>& underlay = {}, std::span<const SvgNote> notes = {});
void write_drawing_svg(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers);

}  // namespace ilot
