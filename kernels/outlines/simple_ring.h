// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/ring.h"

namespace ilot {

// Whether the closed ring, with its last corner not repeated, has an area and does not touch itself. The test is exact.
// O(n^2) at worst, less where edges are short.
bool is_simple_ring(std::span<const Point2> ring);

// Whether the rings are one valid polygon. No two edges may meet except neighbours in their common corner. The first
// ring runs counter-clockwise and contains the others. The others run clockwise and do not contain each other. The test
// is exact. The cost is as above, over all rings.
bool is_simple_polygon(std::span<const std::vector<Point2>> rings);

}  // namespace ilot
