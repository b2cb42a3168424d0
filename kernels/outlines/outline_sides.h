// SPDX-License-Identifier: Apache-2.0
// The straight sides of an outline: the first half of regularise.h.
#pragma once
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// The line of one edge of the outline. Its direction is that of the ring, so the inside is on its left.
struct OutlineSide {
  FlatPoint centre, direction;
  double length = 0;
  double scatter2 = -1;  // mean squared distance of its boundary points from it; -1 = too few to tell
  FlatPoint from, to;    // where the boundary comes from the edge before and where it goes to the next one
  int family = -1;       // main direction to which the side is turned; -1 = none
};

// Returns the sides of each ring. The main directions of all rings come from lines through parts of the boundary that
// are straight within the tolerance. Then each ring is divided into the fewest sides that the boundary points allow
// (side_split.h), most of them along the main directions. Rings and tolerance are in lattice units near the origin.
std::vector<std::vector<OutlineSide>> sides_of(std::span<const std::vector<Point2>> rings, double tolerance);

// Computes where two lines meet. Returns false when they are too nearly parallel.
bool meet(const OutlineSide& a, const OutlineSide& b, FlatPoint& at);

// Whether both have the same main direction and are not perpendicular to each other.
bool parallel(const OutlineSide& a, const OutlineSide& b);

}  // namespace ilot
