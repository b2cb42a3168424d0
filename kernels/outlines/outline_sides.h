// SPDX-License-Identifier: Apache-2.0
// The straight sides of an outline: the first half of regularise.h.
#pragma once
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// A line that an edge of the outline lies on, in the sense of the ring: the inside is on its left.
struct OutlineSide {
  FlatPoint centre, direction;
  double length = 0;
  double scatter2 = -1;  // mean squared distance of its boundary points from it; -1 = too few to tell
  FlatPoint from, to;    // where the boundary passes from the edge before and to the next one
  int family = -1;       // main direction that it keeps to
};

// Per ring its sides, split within the tolerance, fitted, turned to the main directions of all rings, without cuts
// across corners, joined where they go on along each other. Rings and tolerance in lattice units near the origin.
std::vector<std::vector<OutlineSide>> sides_of(std::span<const std::vector<Point2>> rings, double tolerance);

// Where two lines meet; false when they are too nearly parallel.
bool meet(const OutlineSide& a, const OutlineSide& b, FlatPoint& at);

// Of one main direction, and not square to each other.
bool parallel(const OutlineSide& a, const OutlineSide& b);

}  // namespace ilot
