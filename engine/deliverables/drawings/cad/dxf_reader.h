// SPDX-License-Identifier: Apache-2.0
// DXF drawings (ASCII, R12 to today) as they are in the file: layers, units and flat geometry of the model space.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {

struct DxfEntity {
  std::string type, layer, handle;     // LINE, LWPOLYLINE, ARC...; the handle may be empty
  std::uint64_t line = 0;              // line of the file where it begins, from 1
  std::vector<DrawingCorner> corners;  // of lines and polylines; the place of points and texts; the centre of arcs
  bool closed = false;
  double radius = 0, from_deg = 0, to_deg = 0;  // of arcs and circles
  std::string text;                             // of an INSERT the name of its block
  double scale_x = 1, scale_y = 1;              // of an INSERT; from_deg is its rotation
  bool in_block = false;                        // it stands in the block of the INSERT before it
  bool finite = true;                           // false: one of its numbers is not finite; it is read as 0
};

struct DxfDrawing {
  std::string version;                // AC1015
  std::optional<std::int64_t> units;  // $INSUNITS: 6 metres, 4 millimetres, 0 unknown
  std::set<std::string> sections, layers;
  std::vector<DxfEntity> entities;
  bool has_end = false;  // EOF
};

// Entities of the paper space are left out, and so are meshes. Behind an INSERT stand the entities of its block at
// their places in the drawing, without handles and on the layer of the INSERT where theirs is 0; blocks in blocks up to
// eight deep and a million entities in all, more is an Error. Unknown kinds are kept without geometry. The input is not
// trusted: an Error names the file and the line when a group code is not a number, a section is not closed, or a pair
// is cut. Memory grows with the file, of which at most 256 MiB are read.
DxfDrawing read_dxf(const std::filesystem::path& path);
DxfDrawing parse_dxf(std::string_view text, const std::string& name);

bool is_dxf_file(const std::filesystem::path& path);  // by its extension

}  // namespace ilot
