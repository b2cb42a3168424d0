// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/ring.h"

namespace ilot {

// Does the closed ring, its last corner not repeated, have an area and nowhere touch itself? Exact.
// O(n^2) at worst, less where edges are short.
bool is_simple_ring(std::span<const Point2> ring);

// Whether the rings are one valid polygon: no two edges meet but neighbours in their common corner, the first ring runs
// counter-clockwise and holds the others, which run clockwise beside each other. Exact. Cost as above, over all rings.
bool is_simple_polygon(std::span<const std::vector<Point2>> rings);

}  // namespace ilot
