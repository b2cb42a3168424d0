// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in hough_normals.inl, compiled once for each instruction set; the public headers
// say what they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

constexpr std::size_t kHoughVotes = 2048;
constexpr std::uint32_t kHoughRotations = 5;

struct HoughArgs {
  const float *x, *y, *z;
  const std::uint32_t* queries;
  std::uint32_t query_count;
  const std::uint32_t* neighbours;  // k per query, all present
  int k;                            // 3 to 64
  const std::uint32_t* offsets;     // a b per round
  std::uint32_t rounds;             // rounds x k, k rounded up to 16, at most kHoughVotes
  const float* rotations;           // kHoughRotations matrices, row by row
  double* out;                      // x y z per query, of unit length or all zero
};

struct HoughNormalsBody {
  void (*hough_directions)(const HoughArgs&);
};
extern const Variants<HoughNormalsBody> kHoughNormals;

}  // namespace ilot::simd
