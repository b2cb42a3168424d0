// SPDX-License-Identifier: Apache-2.0
// Outlines of elements without openings, stones above all [Marchand 2018, II.3.1].
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

// Convex hull, counter-clockwise from the smallest point in (x, y), without points on its edges; of points that
// coincide the one with the smallest index. Points on a line give its two ends, points at one place one. Exact.
// Monotone chain (Andrew 1979), O(n log n).
std::vector<std::uint32_t> convex_hull(std::span<const Point2> points);

struct PlanePosition {
  double x = 0, y = 0;
};

// The right-angled 4-gon of least area that holds a convex hull, counter-clockwise; one side lies along a hull edge
// (Freeman, Shapira 1975), of equal areas the first. A hull of fewer than three vertices gives its ends twice over.
// Rotating calipers, O(n).
std::array<PlanePosition, 4> right_angled_outline(std::span<const std::uint32_t> hull, std::span<const Point2> points);

}  // namespace ilot
