// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/geometry/box3.h"
#include "kernels/shapes/shape.h"
#include "kernels/shapes/shape_index.h"

namespace ilot {

struct ShapeScoreParams {
  double epsilon = 0;  // units, inclusive
  double min_cos = 0;  // of the angle between a point's normal and the shape's
};

// Returns an upper bound of score_shape: the number of points in the leaves near the shape. It is much cheaper.
// O(leaves met).
std::uint32_t bound_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

// Counts the points within epsilon of the shape whose normal agrees, judged in float32. Balls that are farther away
// than epsilon plus the rounding are skipped, which cannot change the count. The count is the same for every
// instruction set.
std::uint32_t score_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

// A count of score_shape and the epoch of the index in which it was made. Epoch 0 means that there is no count.
struct ShapeCount {
  std::uint32_t points = 0;
  std::uint64_t epoch = 0;
};

// Returns the result of score_shape. Where there is a count before, and all points removed since are listed, it
// subtracts those of them that are on the shape. Else it counts anew, and a result below `least` may be only an upper
// bound.
std::uint32_t recount_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params,
                            ShapeCount before, std::uint32_t least);

// Returns the positions, ascending, of the points within epsilon whose normal agrees, judged in double. Points are
// preselected in float32 with bounds wider than its rounding.
std::vector<std::uint32_t> points_on_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

// Returns only those of these points that are in the box. Leaves outside the box are skipped.
std::vector<std::uint32_t> points_on_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params,
                                           const Box3<Vec3>& box);

}  // namespace ilot
