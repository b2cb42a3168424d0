// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/planes/shape.h"
#include "kernels/planes/shape_index.h"

namespace ilot {

struct ShapeScoreParams {
  double epsilon = 0;  // units, inclusive
  double min_cos = 0;  // of the angle between a point's normal and the shape's
};

// At least as many points as score_shape would count: those of the leaves that come near. Far cheaper. O(leaves met).
std::uint32_t bound_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

// Points within epsilon of the shape whose normal agrees, judged in float32. Balls that lie farther away than epsilon
// and the rounding are passed over, which cannot change the count. Same count for every instruction set.
std::uint32_t score_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

// Positions of the points within epsilon whose normal agrees, ascending, judged in double: culled by float32 with
// bounds wider than its rounding.
std::vector<std::uint32_t> points_on_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

}  // namespace ilot
