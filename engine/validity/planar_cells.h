// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

// The lines cut the inside of a triangle into cells: a point well inside of each cell of at least `least_area`, in an
// order that depends on the input alone. Lines may cross, overlap and leave the triangle; they are noded on a grid of
// whole numbers (GEOS).
std::vector<FlatPoint> cell_points(std::span<const FlatPoint, 3> triangle, std::span<const FlatEdge> lines,
                                   double least_area);

}  // namespace ilot
