// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/flat.h"

namespace ilot {

// The points whose Voronoi cell (among all the points) meets one of the edges in more than a point: those that are the
// nearest point of some stretch of an edge. [C7's Bm] No Voronoi diagram is built: along an edge, squared distances to
// points differ by linear functions, so the nearest ones are the lower envelope of lines, taken over the points around
// the edge that can matter, and over more of them until none is missing. Points at one place have one cell; all of them
// are flagged. Edges without length meet nothing. Coordinates relative to a near anchor. Flags, one per point.
// O(n + m log m), m the points near edges, where points are spread evenly.
std::vector<std::uint8_t> cells_on_edges(std::span<const FlatPoint> points, std::span<const FlatEdge> edges);

}  // namespace ilot
