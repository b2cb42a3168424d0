// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

using Segment = std::pair<std::uint32_t, std::uint32_t>;

struct Constraints {
  std::vector<std::uint8_t> fixed;   // per edge of the triangulation 1 when it lies on a segment
  std::uint32_t crossing = kNoEdge;  // the first segment that crosses one before it; it and those after it are left out
};

// Makes segments between corners of a Delaunay triangulation edges of it: a segment that passes through corners becomes
// several edges. The result is the constrained Delaunay triangulation: across an edge that is not fixed no corner lies
// in a triangle's circle. Among points on a circle in_circle() decides, but fixed edges may leave more than one answer,
// so the order of segments counts there. Exact. Edges in the way are flipped until none is (Sloan 1993), then the new
// ones until they are Delaunay. About the square root of the number of points a segment across them all.
Constraints insert_segments(Triangulation& t, std::span<const Point2> points, std::span<const Segment> segments);

// Per triangle 1 when it lies inside of closed lines made of segments, which have the inside on their left. The
// triangulation must hold them all: triangles left of a segment are inside, and so are those reached without crossing
// one. O(n).
std::vector<std::uint8_t> triangles_inside(const Triangulation& t, const Constraints& constraints,
                                           std::span<const Segment> segments);

}  // namespace ilot
