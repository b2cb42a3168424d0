// SPDX-License-Identifier: Apache-2.0
// A flat drawing that does not depend on a file format: its pieces, in metres, each on the layer of its meaning. All
// formats are written from it, so that they cannot contradict each other.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernels/geometry/flat.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {

// What a piece of a drawing means. drawing_layers.h gives the layer of each meaning, with its name, colour and pen.
enum class DrawingRole : std::uint8_t {
  outline,
  opening,
  sill,
  lintel,
  balcony,
  band,
  bulge,         // relief that is nothing of what is named here
  irregularity,  // where the wall is not even
  stone,
  joint,
  detail,     // elements of other kinds
  hidden,     // lines behind an element that stands before them
  completed,  // drawn although it has no points of its own
  occluded,   // edges in a laser shadow
  shadow,     // hatching of places in a laser shadow
  possible,   // rectangles that nobody saw and that may be openings
  error,      // the plan widened by each edge's error
  ground,
  number,
  level,
  dimension,
  mark,  // where sections are cut, and north
  frame,
  title,
  section,         // surfaces that are cut
  section_points,  // points near the cut
  image,           // the orthoimage under the drawing
};
constexpr std::size_t kDrawingRoles = 27;

// Returns "outline", "opening" and so on, as mapping files name them.
const char* name_of(DrawingRole role);

// The stretch from this corner to the next is an arc when bulge is not 0. The bulge is the tangent of a quarter of the
// angle of the arc; it is positive when the arc turns left.
struct DrawingCorner {
  double x = 0, y = 0, bulge = 0;
};

struct DrawingLine {
  DrawingRole role = DrawingRole::detail;
  std::vector<DrawingCorner> corners;
  bool closed = false;
  bool is_sample = false;  // a sample of the role's pen for the legend; it is on the layer of titles
};

// The arc runs counter-clockwise from one direction to the other.
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
  double x = 0, y = 0;  // a place on the base line of the text
  double height = 0;    // of capital letters
  double rotation_deg = 0;
  TextAnchor anchor = TextAnchor::left;
  std::string text;  // UTF-8, one line
};

// A distance along x or y that is written on the drawing. CAD programs measure it again when it is edited.
struct DrawingDimension {
  FlatPoint from, to;    // the places that are measured
  bool upright = false;  // along y; else along x
  double at = 0;         // y of the line of the dimension; its x when it is upright
  DrawingText text;
  std::vector<DrawingLine> lines;  // its picture, without the text
};

// What a schedule of openings has of one of them.
struct DrawingAttribute {
  std::string tag, value;  // the tag consists of capitals: "WIDTH"
};

// Pieces that belong together, an opening: a block with attributes where the format has blocks. Its pieces are at their
// places in the drawing.
struct DrawingBlock {
  std::string kind;  // "window"
  FlatPoint place;
  std::vector<DrawingLine> lines;
  std::vector<DrawingArc> arcs;
  std::vector<DrawingAttribute> attributes;
};

// A raster under the drawing. The file is named as seen from the drawing's folder.
struct DrawingImage {
  std::string file;
  std::uint32_t width = 0, height = 0;  // pixels
  FlatBox place;
};

struct Drawing {
  std::string title;
  double scale = 50;           // 1 : scale on paper
  FlatBox sheet;               // paper, in metres of the drawing
  bool decimal_comma = false;  // of measured lengths
  std::vector<DrawingLine> lines;
  std::vector<DrawingArc> arcs;
  std::vector<DrawingPoint> points;
  std::vector<DrawingText> texts;
  std::vector<DrawingDimension> dimensions;
  std::vector<DrawingBlock> blocks;
  std::optional<DrawingImage> image;

  // Returns the length in the drawing, in metres, of a length on paper in millimetres.
  double paper_mm(double mm) const { return mm * scale / 1000; }
};

// Returns the drawing with the pieces of its dimensions and blocks among its own lines, arcs and texts.
Drawing flattened(const Drawing& drawing);

// Returns the width of a line of text, in the unit of its height. The digits of the fonts in use are 0.78 heights wide.
double text_width(const std::string& text, double height);

// Returns the box around the lines, arcs, points, texts, dimensions and blocks of a drawing. It is all zero when the
// drawing has none.
FlatBox extent_of(const Drawing& drawing);

// The key is equal for lines that coincide to a hundredth of a millimetre. The corner at which a closed line begins and
// the direction of a line do not change it.
std::vector<std::int64_t> place_key(const std::vector<DrawingCorner>& corners, bool closed);

// Returns valid UTF-8 on one line. Control characters become blanks, invalid bytes become U+FFFD.
std::string clean_text(const std::string& text);

// Returns the code points of valid UTF-8.
std::vector<char32_t> code_points(const std::string& text);

// Returns the number with this count of decimals, never "-0.00". Throws Error when the number is not finite.
std::string decimal(double value, int decimals);

}  // namespace ilot
