// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ilot/delaunay.h"
#include "kernels/delaunay/plane_order.h"
#include "kernels/delaunay/predicates.h"

namespace ilot {

constexpr std::uint32_t next_edge(std::uint32_t e) {
  return e % 3 == 2 ? e - 2 : e + 1;
}
constexpr std::uint32_t previous_edge(std::uint32_t e) {
  return e % 3 == 0 ? e + 2 : e - 1;
}

// Computes the Delaunay triangulation. Corners are indices of points. It is unique, because in_circle() decides ties:
// the triangles, their order and their first corners, as positions, depend on the set of positions alone. Of points
// that coincide, the one with the smallest index is used. There are no triangles when all points are on a line. There
// are at most 2^29 points. The method is divide and conquer (Guibas, Stolfi 1985) along the Morton order of the points,
// whose cells are halved in alternating directions (Dwyer 1987). It is O(n log n) on scanned points and never worse
// than O(60 n). It needs about 170 bytes of working memory per point. It runs on the threads of the calling arena.
Triangulation delaunay(std::span<const Point2> points);

// The same for points that are already in order and have no duplicates. Corners are positions in the order.
Triangulation delaunay(const PlaneOrder& order);

}  // namespace ilot
