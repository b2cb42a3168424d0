// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

// Distinct points of the plane along the Morton curve. Bit i of x and y, counted from the smallest coordinates of all
// points, is bit 2i and 2i+1 of a code, so points that share the upper bits of their codes lie in one aligned cell.
struct PlaneOrder {
  std::vector<Point2> points;
  std::vector<std::uint64_t> codes;  // strictly ascending, below 2^62
  std::vector<std::uint32_t> index;  // where the point stood; the smallest index of those that coincide
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates;  // (index left out, index kept), along the curve
};

// At most 2^30 points. Radix sort from the upper digits: O(n) for scanned points, O(n log n) at worst; 32 bytes of
// working memory a point. On the threads of the calling arena.
PlaneOrder plane_order(std::span<const Point2> points);

// Those of the points, by their positions in the order, whose flag is 1; without the duplicates. O(n).
PlaneOrder selected(const PlaneOrder& order, std::span<const std::uint8_t> flags);

}  // namespace ilot
