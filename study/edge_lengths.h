// SPDX-License-Identifier: Apache-2.0
// Boundary points without dropping triangles: the ends of long edges [C5, the operator after Boulaassal 2010].
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

// Returns the length at which the sorted lengths of all edges change their slope. It is the length farthest below the
// straight line from the shortest to the longest one, where each length is plotted against its place in the order.
// Edges within a surface are short and nearly equal. Edges across its gaps and bays are few and long. If the lengths
// have no such bend, for example if all are equal, the result is half a unit more than the longest one. Without edges
// it is 0.5. The unit is the lattice unit. O(n log n).
double slope_change(const Triangulation& t, std::span<const Point2> points);

// Returns 1 for each point that is an end of an edge longer than `threshold`. O(n).
std::vector<std::uint8_t> ends_of_long_edges(const Triangulation& t, std::span<const Point2> points, double threshold);

}  // namespace ilot
