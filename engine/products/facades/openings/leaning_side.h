// SPDX-License-Identifier: Apache-2.0
// Sides of openings that are neither level nor upright: leaning jambs, heads under a slope.
#pragma once
#include <optional>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// A side t = at + lean (s - middle). t and s are in the axes of the wall: u and v for left and right, v and u for
// bottom and top.
struct LeaningSide {
  double at = 0, lean = 0, rms = 0, error = 0;
};

// Finds where rays no longer go through the wall, in intervals along the side, and fits a line by least squares. There
// is no result if the line leans by at most the error of the side, or if it fits less than three times better than the
// straight side. Arcs are found separately (arched_top.h). O(n log n) in the points around.
std::optional<LeaningSide> find_leaning_side(const RaySamples& samples, const FoundRectangle& opening, Side side);

}  // namespace ilot
