// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

// The points whose Voronoi cell (among all the points) meets one of the edges in more than a point: those that are the
// nearest point of some stretch of an edge. [C7's Bm] No Voronoi diagram is built. An edge is walked by questions for
// the nearest point (continuous nearest neighbour search, Tao, Papadias, Shen 2002): cells are convex, so the same
// answer at both ends holds between them; else the place where the two answers are equally far splits the rest or is
// where their cells meet. Stretches below 2^-40 of the edge's length are rounding. Points at one place have one cell,
// and points mirrored in an edge share it: all of them are flagged. Edges without length meet nothing. Coordinates
// relative to a near anchor. Flags, one per point. O(n log n) for the tree, O(log n) for each cell on an edge.
std::vector<std::uint8_t> cells_on_edges(std::span<const FlatPoint> points, std::span<const FlatEdge> edges);

}  // namespace ilot
