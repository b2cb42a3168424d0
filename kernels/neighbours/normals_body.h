// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in normals.inl, compiled once for each instruction set; the public headers say
// what they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

struct NormalArgs {
  const float *x, *y, *z;
  const std::uint32_t* queries;
  std::uint32_t query_count;
  const std::uint32_t* neighbours;  // k per query, all present, squared distances below 2^24
  int k;                            // at most 64
  std::int16_t* out;                // x y z and curvature as uint16 per query
};

struct NormalsBody {
  void (*neighbour_normals)(const NormalArgs&);
};
extern const Variants<NormalsBody> kNormals;

}  // namespace ilot::simd
