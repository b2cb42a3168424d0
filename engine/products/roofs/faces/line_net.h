// SPDX-License-Identifier: Apache-2.0
// Straight segments brought to meet only in points of the grid of whole numbers.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

struct NetSegment {
  Point2 a, b;
  bool border = false;  // of the area that the net parts
};

struct NetEdge {
  std::uint32_t from = 0, to = 0;  // vertices, from < to
  bool border = false;             // an odd number of the border's segments came to lie here
};

// Edges have no vertex between their ends and meet in vertices only. Vertices ascend, edges by (from, to), none twice.
struct LineNet {
  std::vector<Point2> vertices;
  std::vector<NetEdge> edges;
};

// Snap rounding [Hobby 1999]: every end of a segment and every crossing of two, rounded, is a vertex, and a segment
// that passes within half a unit of a vertex, along x as along y, goes through it; so segments move by less than a unit
// and what crosses still crosses. Exact in integers, so the answer is a property of the set of segments. Coordinates
// within kMaxPlaneCoordinate. O(segments^2 + segments x vertices) comparisons at worst, of those alone whose extents
// along x overlap.
LineNet snap_rounded(std::span<const NetSegment> segments);

}  // namespace ilot
