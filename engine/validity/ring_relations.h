// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

// Returns the fault in the relation of a polygon's rings, each of which is simple. 0 = no fault, 201 rings cross or
// share a piece of an edge, 202 two rings are the same, 205 the rings cut the inside in two, 206 a hole is outside, 207
// a hole is in another hole, 999 any other fault. GEOS decides; rings may touch in points.
int ring_relation_fault(std::span<const std::vector<Point2>> rings);

}  // namespace ilot
