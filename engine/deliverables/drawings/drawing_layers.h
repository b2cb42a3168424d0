// SPDX-License-Identifier: Apache-2.0
// The layers of an office's drawings: the name, colour and pen for each meaning of a drawing.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {

constexpr double kThinnestPen = 0.05;  // mm; thinner pens are drawn with this width

enum class LinePattern : std::uint8_t { continuous, dashed, dotted };

struct DrawingLayer {
  std::string name;             // ASCII, 1 to 255 characters, none of <>/\":;?*|,=`
  int colour = 7;               // AutoCAD colour index, 1 to 255; 7 is black on paper
  double lineweight_mm = 0.25;  // one of the pens of the exchange format
  LinePattern pattern = LinePattern::continuous;
  bool shown = true;  // false: the layer is written, but frozen
};

struct DrawingLayers {
  std::array<DrawingLayer, kDrawingRoles> of_role;
  const DrawingLayer& operator[](DrawingRole role) const { return of_role[static_cast<std::size_t>(role)]; }
};

// Known presets are "ilot", "aia" and "iso13567". Any other name is a usage Error that lists them.
DrawingLayers preset_layers(std::string_view name);

// Takes the name of a preset, or a mapping file: TOML with `preset = "ilot"` and, for roles that differ from the
// preset, `[layers.opening]` with `name`, `colour`, `lineweight_mm`, `pattern`, `shown`. Roles may share a layer when
// they agree on everything. A usage Error names the file and the place of the fault. The input is not trusted.
DrawingLayers read_layers(const std::string& preset_or_file);
DrawingLayers parse_layers(std::string_view toml, const std::string& name);

// Returns red, green and blue of a colour index on white paper.
std::array<std::uint8_t, 3> colour_on_paper(int colour);

const char* name_of(LinePattern pattern);

}  // namespace ilot
