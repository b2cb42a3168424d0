// SPDX-License-Identifier: Apache-2.0
// Outlines of elements without openings, above all of stones [Marchand 2018, II.3.1].
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

// Returns the convex hull, counter-clockwise from the smallest point in (x, y), without points on its edges. Of points
// that coincide, the one with the smallest index is used. Points on a line give its two ends, and points at one place
// give one. The result is exact. Monotone chain (Andrew 1979), O(n log n).
std::vector<std::uint32_t> convex_hull(std::span<const Point2> points);

struct PlanePosition {
  double x = 0, y = 0;
};

// Returns the rectangle of least area that contains a convex hull, counter-clockwise. One side is along an edge of the
// hull (Freeman, Shapira 1975). Of equal areas the first is taken. A hull of fewer than three vertices gives its ends
// twice. Rotating calipers, O(n).
std::array<PlanePosition, 4> right_angled_outline(std::span<const std::uint32_t> hull, std::span<const Point2> points);

}  // namespace ilot
