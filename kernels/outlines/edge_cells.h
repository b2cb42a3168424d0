// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

// Flags the points whose Voronoi cell (among all the points) meets one of the edges in more than one point. These are
// the points that are nearest to some stretch of an edge. [C7's Bm] No Voronoi diagram is built. The function walks
// along an edge with queries for the nearest point (continuous nearest neighbour search, Tao, Papadias, Shen 2002).
// Cells are convex, so when both ends have the same nearest point, it is the nearest point between them too. Otherwise
// the place with equal distance to the two points either splits the rest or is the place where their cells meet.
// Stretches shorter than 2^-40 of the length of the edge count as rounding. Points at one place have one cell, and two
// points mirrored at an edge share it: all of them are flagged. Edges without length meet nothing. Coordinates are
// relative to a near anchor. The result has one flag per point. O(n log n) for the tree, O(log n) for each cell on an
// edge.
std::vector<std::uint8_t> cells_on_edges(std::span<const FlatPoint> points, std::span<const FlatEdge> edges);

}  // namespace ilot
