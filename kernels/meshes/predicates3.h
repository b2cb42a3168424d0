// SPDX-License-Identifier: Apache-2.0
// Exact predicates of space. Coordinates are integers, so that 128 bits hold every determinant: no rounding.
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

// 1 when d lies on the side of a, b, c from which they turn left, 0 on their plane, -1 on the other side.
int orient3d_sign(Index3 a, Index3 b, Index3 c, Index3 d);

// Of the triangle's two area vectors, seen from above the largest component's axis: its index 0..2; -1 for a triangle
// without area.
int widest_axis(const IndexTriangle& t);

// Of points on the coordinate plane that leaves out `axis`: 1 when a, b, c turn left, 0 on a line, -1 right.
int orient2d_sign(Index3 a, Index3 b, Index3 c, int axis);

// Do the closed segment and the closed triangle share a point? The triangle has an area.
bool segment_meets_triangle(Index3 p, Index3 q, const IndexTriangle& t);

// Do two closed triangles with areas share a point?
bool triangles_meet(const IndexTriangle& s, const IndexTriangle& t);

}  // namespace ilot
