// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

// Returns a point well inside of each cell of at least `least_area`. The cells are those into which the lines cut a
// triangle. The order depends on the input alone. Lines may cross, overlap and leave the triangle; they are noded on a
// grid of whole numbers (GEOS).
std::vector<FlatPoint> cell_points(std::span<const FlatPoint, 3> triangle, std::span<const FlatEdge> lines,
                                   double least_area);

}  // namespace ilot
