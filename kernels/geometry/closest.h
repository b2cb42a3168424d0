// SPDX-License-Identifier: Apache-2.0
// Closest points on segments and triangles, in doubles.
#pragma once
#include "kernels/core/types.h"

namespace ilot {

struct Triangle3 {
  Vec3 a, b, c;
};

// Returns the point of the closed segment nearest to p. It returns `a` when the segment has no length. O(1).
Vec3 closest_on_segment(Vec3 p, Vec3 a, Vec3 b);

// Returns the point of the closed triangle nearest to p. A triangle without area counts as its longest edge.
// Coordinates should be relative to a near anchor, because products of national coordinates lose digits while
// differences do not. O(1).
Vec3 closest_on_triangle(Vec3 p, const Triangle3& triangle);

}  // namespace ilot
