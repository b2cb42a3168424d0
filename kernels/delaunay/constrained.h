// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

struct Constraints {
  std::vector<std::uint8_t> fixed;   // 1 for each edge of the triangulation that is part of a segment
  std::uint32_t crossing = kNoEdge;  // first segment that crosses an earlier one; it and all later ones are left out
};

// Inserts segments between corners of a Delaunay triangulation as edges. A segment that passes through corners becomes
// several edges. The result is the constrained Delaunay triangulation: across an edge that is not fixed, no corner is
// in the circle of a triangle. For points on a circle in_circle() decides. There the fixed edges may allow more than
// one result, and the order of the segments matters. The result is exact. Edges that cross the segment are flipped
// until none is left (Sloan 1993), and then the new edges until they are Delaunay. A segment across all n points takes
// about the square root of n steps.
Constraints insert_segments(Triangulation& t, std::span<const Point2> points, std::span<const VertexPair> segments);

// Returns for each triangle 1 when it is inside of closed lines made of segments, which have the inside on their left.
// The triangulation must contain all segments. Triangles left of a segment are inside, and so are those that can be
// reached from them without crossing a segment. O(n).
std::vector<std::uint8_t> triangles_inside(const Triangulation& t, const Constraints& constraints,
                                           std::span<const VertexPair> segments);

}  // namespace ilot
