// SPDX-License-Identifier: Apache-2.0
// The outline of a wall with the sparse parts beside it.
#pragma once
#include <vector>

#include "engine/products/facades/rays/ray_samples.h"
#include "engine/products/facades/walls/wall_outline.h"

namespace ilot {

// A column of a sparse part, and the highest place of the wall in it; -infinity where the wall has fewer than two
// points.
struct SparseColumn {
  double u0 = 0, u1 = 0, top = 0;  // metres, in the axes of the wall
};

// The columns of a part of a wall from u0 to u1, half a metre wide, in the axes of `samples`. O(points).
std::vector<SparseColumn> sparse_columns(const RaySamples& samples, double u0, double u1);

// The outline of the dense part of a wall, which goes from 0 to `width`, with the columns of its sparse parts beside
// it, in the order of their places. `whole` is the box of all. Each stretch of columns of nearly one height has this
// height, or that of the box where it is near that. Without columns the outline is the box. `step` is that of the
// sparsest part.
WallOutline outline_with_columns(const WallOutline& core, double width, std::vector<SparseColumn> columns,
                                 const Box2& whole, double step);

}  // namespace ilot
