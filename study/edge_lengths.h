// SPDX-License-Identifier: Apache-2.0
// Boundary points without triangles to drop: the ends of long edges [C5, the operator after Boulaassal 2010].
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

// Length at which the sorted lengths of all edges change their slope: the one farthest below the straight line from the
// shortest to the longest, each against its place in the order. Edges within a surface are short and nearly equal,
// those that span its gaps and bays are few and long. Where the lengths have no such bend, as where all are equal, half
// a unit more than the longest; 0.5 without edges. In lattice units. O(n log n).
double slope_change(const Triangulation& t, std::span<const Point2> points);

// Per point 1 when it is an end of an edge longer than `threshold`. O(n).
std::vector<std::uint8_t> ends_of_long_edges(const Triangulation& t, std::span<const Point2> points, double threshold);

}  // namespace ilot
