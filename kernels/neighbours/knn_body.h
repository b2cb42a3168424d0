// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in knn.inl, compiled once for each instruction set; the public headers say what
// they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

struct KnnArgs {
  const float *x, *y, *z;
  std::uint32_t size;
  const float* const* boxes;  // per level: nodes of 8 child boxes, 48 floats each: min x8 y8 z8, max x8 y8 z8
  int levels;
  const std::uint32_t* queries;
  std::uint32_t query_count;
  int k;
  std::int64_t max_d2;
  std::uint32_t* neighbours;  // k per query
  std::int64_t* reach2;       // one per query
};

struct KnnBody {
  void (*knn)(const KnnArgs&);
};
extern const Variants<KnnBody> kKnn;

}  // namespace ilot::simd
