// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

// Distinct points of the plane along the Morton curve. Coordinates are counted from the smallest coordinates of all
// points. Bit i of x and y is bit 2i and 2i+1 of a code, so points with the same upper bits of their codes are in one
// aligned cell.
struct PlaneOrder {
  std::vector<Point2> points;
  std::vector<std::uint64_t> codes;  // strictly ascending, below 2^62
  std::vector<std::uint32_t> index;  // index of the point in the input; the smallest index of points that coincide
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates;  // (index left out, index kept), along the curve
};

// There are at most 2^30 points. It is a radix sort from the upper digits: O(n) for scanned points, O(n log n) at
// worst. It needs 32 bytes of working memory per point. It runs on the threads of the calling arena.
PlaneOrder plane_order(std::span<const Point2> points);

// Returns the points whose flag is 1, by their positions in the order, without the duplicates. O(n).
PlaneOrder selected(const PlaneOrder& order, std::span<const std::uint8_t> flags);

}  // namespace ilot
