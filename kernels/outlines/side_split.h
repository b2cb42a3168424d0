// SPDX-License-Identifier: Apache-2.0
// Divides a boundary into the straight sides that describe it in the fewest words.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

constexpr std::int32_t kOwnDirection = -1;

// Consecutive vertices of a ring that lie on one line. They may continue beyond the end of the ring.
struct SideSpan {
  std::uint32_t first = 0, count = 0;
  std::int32_t axis = kOwnDirection;  // index of the axis that the line follows
};

// Returns the sides of a closed ring of vertices that lie beside their lines by `sigma` (normal distribution). Each
// line follows one of the axes (unit vectors, no two parallel), which costs little, or a direction of its own, which
// costs more. Of all ways to divide the ring, the result has the least description length [Rissanen 1978]: the length
// of the list of sides and the negative logarithm of the likelihood of the vertices. Vertices are divided between two
// sides, not shared by them, so where a boundary cuts across a corner the sides meet in the corner. Where two sides
// that follow each other are parallel, the step between them counts as a side. Dynamic programming with exact pruning
// [Killick et al. 2012]. It is solved twice, from a vertex and then from the end of a side that was found, so that the
// result does not depend on where the ring begins. The sides are in the order of the ring; the first one contains
// vertex 0 or is the first to begin after it. O(vertices x vertices of a side x axes).
std::vector<SideSpan> split_sides(std::span<const FlatPoint> ring, std::span<const FlatPoint> axes, double sigma);

}  // namespace ilot
