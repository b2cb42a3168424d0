// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in shape_score.inl, compiled once for each instruction set; the public headers say
// what they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

struct ShapeArgs {
  const float *x, *y, *z, *nx, *ny, *nz;  // leaves of 64 points; holes are not numbers
  const float* const* balls;              // per level: groups of 8, 32 floats each: x8 y8 z8 radius8
  int levels;
  const float* shape;  // origin, axis, radius, sine, cosine
  int kind;            // ShapeKind
  float max_distance, min_cos;
  float slack;            // more than rounding adds to a distance
  std::uint32_t* leaves;  // shape_leaves writes, shape_hits reads
  std::uint32_t leaf_count;
  std::uint32_t* found;  // nullptr: count only; else positions, with room for eight more
};

struct ShapeScoreBody {
  std::uint32_t (*shape_hits)(const ShapeArgs&);    // how many points of the leaves
  std::uint32_t (*shape_leaves)(const ShapeArgs&);  // how many leaves
};
extern const Variants<ShapeScoreBody> kShapeScore;

}  // namespace ilot::simd
