// SPDX-License-Identifier: Apache-2.0
// Exact predicates of space. Coordinates are integers, so 128 bits are enough for every determinant and there is no
// rounding.
#pragma once
#include <cstdint>

#include "kernels/geometry/box3.h"

namespace ilot {

// Largest magnitude of a coordinate: 549 km at a micrometre.
constexpr std::int64_t kMaxSpaceCoordinate = std::int64_t{1} << 39;

struct IndexTriangle {
  Index3 a, b, c;
};

inline IndexBox box_of(const IndexTriangle& t) {
  IndexBox box{t.a, t.a};
  box.add(t.b);
  box.add(t.c);
  return box;
}

// 1 when d is on the side of a, b, c from which they turn left, 0 when it is in their plane, -1 when it is on the other
// side.
int orient3d_sign(Index3 a, Index3 b, Index3 c, Index3 d);

// Returns the index 0..2 of the largest component of the area vector of the triangle, or -1 for a triangle without
// area.
int widest_axis(const IndexTriangle& t);

// The points are projected on the coordinate plane without `axis`. The result is 1 when a, b, c turn left, 0 when they
// are on a line, -1 when they turn right.
int orient2d_sign(Index3 a, Index3 b, Index3 c, int axis);

// Whether the closed segment and the closed triangle share a point. The triangle must have an area.
bool segment_meets_triangle(Index3 p, Index3 q, const IndexTriangle& t);

// Whether two closed triangles with areas share a point.
bool triangles_meet(const IndexTriangle& s, const IndexTriangle& t);

}  // namespace ilot
