// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

// Cuts a polygon with holes into triangles by ear clipping, holes linked to the outer ring by bridges (Eberly,
// "Triangulation by ear clipping"). `rings` are index lists into `points`, the outer one first, either orientation, the
// last corner not repeated; rings under three corners are left out. Triangles are counter-clockwise, in a fixed order.
// For simple, disjoint rings they cover the polygon exactly once: outer corners + corners of holes + 2 holes - 2 of
// them. Of rings that cross themselves something is made: as many triangles, whose cover is undefined.
// O(n^2) for the polygons of buildings, O(n^3) at worst.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const FlatPoint> points,
                                                      std::span<const std::vector<std::uint32_t>> rings);

}  // namespace ilot
