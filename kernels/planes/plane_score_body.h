// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in plane_score.inl, compiled once for each instruction set; the public headers say
// what they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

struct CountArgs {
  const float *x, *y, *z, *nx, *ny, *nz;  // nx == nullptr: only the distance counts
  std::size_t size;
  const float* planes;  // a b c d per plane
  std::size_t plane_count;
  float max_distance, min_cos;
  std::uint32_t* counts;  // one per plane, overwritten
};

struct PlaneScoreBody {
  void (*count_inliers)(const CountArgs&);
};
extern const Variants<PlaneScoreBody> kPlaneScore;

}  // namespace ilot::simd
