// SPDX-License-Identifier: Apache-2.0
// Lines behind an element that stands before them.
#pragma once
#include <span>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {

// A ring that hides what is inside of it.
struct Cover {
  std::vector<FlatPoint> ring;
  FlatBox box;
};

// Cuts lines where they go behind covers and moves the hidden pieces to the role `hidden`; bulges are kept as bulges.
// What lies within a millimetre of a cover's ring is not hidden. A closed line that is hidden in part becomes open
// pieces. O(corners of lines times corners of covers).
void hide_lines(std::span<const Cover> covers, std::vector<DrawingLine>& lines);

// Tells whether all places are inside of a ring, or within a millimetre of it.
bool holds_all(const Cover& cover, std::span<const FlatPoint> places);

}  // namespace ilot
