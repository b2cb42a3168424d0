// SPDX-License-Identifier: Apache-2.0
// Shapes and texts of a map as operators of a PDF page (pdf_file.h).
#pragma once
#include <string>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/maps/street_shapes.h"

namespace ilot {

// Where the map lies on the page.
struct MapPlace {
  FlatPoint corner;     // metres on the map
  FlatPoint corner_mm;  // the same place on the page
  double scale = 1;     // 1 : scale

  double mm(double metres) const { return metres * 1000 / scale; }
  FlatPoint mm(FlatPoint p) const { return {corner_mm.x + mm(p.x - corner.x), corner_mm.y + mm(p.y - corner.y)}; }
};

std::string shape_pdf(const MapShape& shape, const MapPlace& place);

struct PageText {
  FlatPoint at;       // millimetres on the page; on the base line
  double height = 2;  // millimetres; of capital letters
  TextAnchor anchor = TextAnchor::left;
  bool halo = false;  // a white edge, so that it can be read on shapes
};
std::string text_pdf(const PageText& place, const std::string& text);

// A frame of thin lines around a box in millimetres on the page.
std::string frame_pdf(const FlatBox& box);

}  // namespace ilot
