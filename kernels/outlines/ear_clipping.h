// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

// Cuts a polygon with holes into triangles by ear clipping. Bridges link the holes to the outer ring (Eberly,
// "Triangulation by ear clipping"). `rings` are index lists into `points`. The outer ring comes first, each ring has
// either orientation, and its last corner is not repeated. Rings with fewer than three corners are left out. Triangles
// are counter-clockwise, in a fixed order. For simple, disjoint rings they cover the polygon exactly once, and their
// number is outer corners + corners of holes + 2 holes - 2. Rings that cross themselves give as many triangles, but
// what these cover is undefined. O(n^2) for the polygons of buildings, O(n^3) at worst.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const FlatPoint> points,
                                                      std::span<const std::vector<std::uint32_t>> rings);

}  // namespace ilot
