// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in radial_sums.inl, compiled once for each instruction set; the public headers say
// what they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

constexpr std::size_t kRadialRows = 16;

struct RadialArgs {
  const double* rows;     // kRadialRows rows, dimension by dimension
  const double* vectors;  // `dimensions` values each
  const double* weights;  // `sums` values each
  std::size_t vector_count, dimensions, sums;
  double gamma;
  double* totals;   // kRadialRows per sum, overwritten
  double* nearest;  // one per row, overwritten
};

struct RadialSumsBody {
  void (*radial_sums)(const RadialArgs&);
};
extern const Variants<RadialSumsBody> kRadialSums;

}  // namespace ilot::simd
