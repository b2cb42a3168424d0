// SPDX-License-Identifier: Apache-2.0
// Whether triangles form an oriented surface, and whether it is closed.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

using TriangleCorners = std::array<std::uint32_t, 3>;

enum class TriangleFit : std::uint8_t {
  fits,
  reversed,  // fits only with the opposite orientation
  none,      // fits in neither orientation: a third triangle at an edge, or a second umbrella at a corner
};

// Tells whether each triangle fits those before it that fit, so that the surface may still become a manifold. Its
// corners must be distinct, no earlier triangle may have an edge in the same direction, and no corner may have a closed
// umbrella and other triangles. Triangles that do not fit are left out. The order of triangles matters. Corners are
// below `vertices`. O(n) for the meshes of buildings, times the number of separate fans at a corner.
std::vector<TriangleFit> fit_triangles(std::span<const TriangleCorners> triangles, std::uint32_t vertices);

// Returns the edges, in the direction of their triangle, that no triangle has in the other direction, ascending. The
// surface is closed when there are none.
std::vector<std::pair<std::uint32_t, std::uint32_t>> open_edges(std::span<const TriangleCorners> triangles);

// Returns the number of pieces. Triangles that share a corner belong to one piece.
std::uint32_t count_pieces(std::span<const TriangleCorners> triangles, std::uint32_t vertices);

// Returns the sign of the volume that a closed surface encloses. It is 1 when the triangles turn left seen from
// outside. It is exact for up to 2^14 triangles within 2^36 of each other, 68 km at a micrometre.
int volume_sign(std::span<const TriangleCorners> triangles, std::span<const Index3> vertices);

}  // namespace ilot
