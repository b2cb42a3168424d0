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

// At least as many points as score_shape would count: those of the leaves that come near. Far cheaper. O(leaves met).
std::uint32_t bound_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

// Points within epsilon of the shape whose normal agrees, judged in float32. Balls that lie farther away than epsilon
// and the rounding are passed over, which cannot change the count. Same count for every instruction set.
std::uint32_t score_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

// A count of score_shape and the epoch of the index in which it was made; 0: none was.
struct ShapeCount {
  std::uint32_t points = 0;
  std::uint64_t epoch = 0;
};

// What score_shape counts, from what it counted before: nothing is counted where no leaf that the shape comes near has
// changed since. Below `least` the answer is only an upper bound, itself below `least`.
std::uint32_t recount_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params,
                            ShapeCount before, std::uint32_t least);

// Positions of the points within epsilon whose normal agrees, ascending, judged in double: culled by float32 with
// bounds wider than its rounding.
std::vector<std::uint32_t> points_on_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params);

// Of these the points in the box: leaves that lie outside it are passed over.
std::vector<std::uint32_t> points_on_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params,
                                           const Box3<Vec3>& box);

}  // namespace ilot
