// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in shape_score.inl, compiled once for each instruction set; the public headers say
// what they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

constexpr std::size_t kBallGroup = 32, kConeGroup = 56;  // floats of eight balls, of eight cones

struct ShapeArgs {
  const float *x, *y, *z, *nx, *ny, *nz;  // leaves of 64 points; holes are NaN
  const float* const* balls;              // per level: groups of 8: x8 y8 z8 radius8
  int levels;
  std::uint32_t first_group, groups;  // where there is one level: the groups that are looked through
  const float* cones;                 // of leaves: groups of 8: x8 y8 z8 cosine8 sine8 middle8 half8
  const float* shape;                 // origin, axis, radius, sine, cosine
  int kind;                           // ShapeKind
  float max_distance, min_cos;
  float slack;  // larger than the rounding error of a distance
  // Of the greatest angle between normals that agree; the rounding of cosines of normals.
  float angle_cosine, angle_sine, cosine_rounding;
  std::uint32_t* leaves;  // shape_leaves writes them, with room for eight more; shape_hits reads them
  std::uint32_t leaf_count;
  std::uint32_t* found;  // nullptr: count only; otherwise positions, with room for eight more
};

struct ShapeScoreBody {
  std::uint32_t (*shape_hits)(const ShapeArgs&);    // returns the number of points of the leaves on the shape
  std::uint32_t (*shape_leaves)(const ShapeArgs&);  // returns the number of leaves
};
extern const Variants<ShapeScoreBody> kShapeScore;

}  // namespace ilot::simd
