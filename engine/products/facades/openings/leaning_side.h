// SPDX-License-Identifier: Apache-2.0
// Sides of openings that are neither level nor upright: leaning jambs, heads under a slope.
#pragma once
#include <optional>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// A side t = at + lean (s - middle), t and s in the wall's axes: u and v of left and right, v and u of bottom and top.
struct LeaningSide {
  double at = 0, lean = 0, rms = 0, error = 0;
};

// Where rays cease to go through the wall, stretch by stretch along the side, a line is fitted by least squares;
// nothing where it leans by no more than the side's error, or fits no three times better than the straight side. The
// arc is looked at by itself (arched_top.h). O(n log n) in the points around.
std::optional<LeaningSide> find_leaning_side(const RaySamples& samples, const FoundRectangle& opening, Side side);

}  // namespace ilot
