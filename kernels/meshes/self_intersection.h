// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/meshes/manifold.h"
#include "kernels/meshes/predicates3.h"

namespace ilot {

// Returns the triangles, in order, that meet another one outside of the corners and edges that they share. Two
// triangles with a common edge meet when they are on the same side of it in one plane. Touching counts as meeting.
// Triangles without area are left out. The result is exact for coordinates within kMaxSpaceCoordinate. Boxes are swept
// along x: about n log n for buildings, n^2 at worst.
std::vector<std::uint32_t> meeting_triangles(std::span<const TriangleCorners> triangles,
                                             std::span<const Index3> vertices);

}  // namespace ilot
