// SPDX-License-Identifier: Apache-2.0
// Straight segments that are changed so that they meet only in points of the grid of whole numbers.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

struct NetSegment {
  Point2 a, b;
  bool border = false;  // it is on the border of the area that the net divides
};

struct NetEdge {
  std::uint32_t from = 0, to = 0;  // vertices, from < to
  bool border = false;             // an odd number of border segments lie here
};

// Edges have no vertex between their ends and meet only in vertices. Vertices are ascending, and edges are ascending by
// (from, to) without duplicates.
struct LineNet {
  std::vector<Point2> vertices;
  std::vector<NetEdge> edges;
};

// Computes a snap rounding [Hobby 1999]. Every end of a segment and every crossing of two segments, rounded, is a
// vertex. A segment that passes within half a unit of a vertex, in x and in y, goes through it. So segments move by
// less than a unit, and segments that cross still cross. The computation is exact in integers, so the result depends
// only on the set of segments. Coordinates are within kMaxPlaneCoordinate. At worst O(segments^2 + segments x vertices)
// comparisons, but only of pairs whose extents along x overlap.
LineNet snap_rounded(std::span<const NetSegment> segments);

}  // namespace ilot
