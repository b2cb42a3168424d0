// SPDX-License-Identifier: Apache-2.0
// A flat drawing before it takes a format: what is on it, in metres, each piece on the layer of its meaning. All
// formats are written from it, so that no two of them can disagree.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/geometry/flat.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {

// What a piece of a drawing means. Which layer that is, its name, colour and pen: drawing_layers.h.
enum class DrawingRole : std::uint8_t {
  outline,
  opening,
  sill,
  lintel,
  balcony,
  band,
  bulge,
  stone,
  joint,
  detail,     // elements of other kinds
  completed,  // drawn without points of its own
  occluded,   // edges in a laser shadow
  shadow,     // hatching of what lies in a laser shadow
  error,      // the plan widened by each edge's error
  number,
  level,
  dimension,
  frame,
  title,
  section,         // surfaces that are cut
  section_points,  // points near the cut
};
constexpr std::size_t kDrawingRoles = 21;

// "outline", "opening"... as mapping files name them.
const char* name_of(DrawingRole role);

// The stretch from this corner to the next is an arc when bulge is not 0: the tangent of a quarter of its angle,
// positive when it turns left.
struct DrawingCorner {
  double x = 0, y = 0, bulge = 0;
};

struct DrawingLine {
  DrawingRole role = DrawingRole::detail;
  std::vector<DrawingCorner> corners;
  bool closed = false;
  bool is_sample = false;  // of the role's pen, for a legend: it lies on the layer of titles
};

// Counter-clockwise from one direction to the other.
struct DrawingArc {
  DrawingRole role = DrawingRole::detail;
  double x = 0, y = 0, radius = 0, from_deg = 0, to_deg = 0;
};

struct DrawingPoint {
  DrawingRole role = DrawingRole::section_points;
  double x = 0, y = 0;
};

enum class TextAnchor : std::uint8_t { left, middle, right };

struct DrawingText {
  DrawingRole role = DrawingRole::title;
  double x = 0, y = 0;  // on its base line
  double height = 0;    // of capitals
  double rotation_deg = 0;
  TextAnchor anchor = TextAnchor::left;
  std::string text;  // UTF-8, one line
};

struct Drawing {
  std::string title;
  double scale = 50;  // 1 : scale on paper
  FlatBox sheet;      // paper, in metres of the drawing
  std::vector<DrawingLine> lines;
  std::vector<DrawingArc> arcs;
  std::vector<DrawingPoint> points;
  std::vector<DrawingText> texts;

  // Metres in the drawing of so many millimetres on paper.
  double paper_mm(double mm) const { return mm * scale / 1000; }
};

// Room that a line of text needs, in the unit of its height: digits of the fonts in use are 0.78 heights wide.
double text_width(const std::string& text, double height);

// What the lines, arcs, points and texts of a drawing cover; all zero when there are none.
FlatBox extent_of(const Drawing& drawing);

// Equal for lines that lie on each other to a hundredth of a millimetre, wherever a closed one begins and whichever way
// it runs.
std::vector<std::int64_t> place_key(const std::vector<DrawingCorner>& corners, bool closed);

// Valid UTF-8 on one line: control characters become blanks, bytes that are none U+FFFD.
std::string clean_text(const std::string& text);

// The code points of valid UTF-8.
std::vector<char32_t> code_points(const std::string& text);

// A number with so many decimals, never "-0.00". Throws Error when it is not finite.
std::string decimal(double value, int decimals);

}  // namespace ilot
