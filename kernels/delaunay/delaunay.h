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

// The Delaunay triangulation; corners are indices of points. Unique: ties are broken as in_circle() says, so the
// triangles, their order and their first corners, as positions, depend on nothing but the set of positions. Of points
// that coincide the one with the smallest index is used. No triangles when all points lie on a line. At most 2^29
// points. Divide and conquer (Guibas, Stolfi 1985) along the Morton order of the points, whose cells are halved across
// and along by turns (Dwyer 1987): O(n log n) on scanned points, never worse than O(60 n). About 170 bytes of working
// memory a point. On the threads of the calling arena.
Triangulation delaunay(std::span<const Point2> points);

// The same of points that are in order already: corners are positions in it, and there are no duplicates.
Triangulation delaunay(const PlaneOrder& order);

}  // namespace ilot
