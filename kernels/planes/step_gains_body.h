// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector body in step_gains.inl, compiled once for each instruction set; the public header says
// what they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

constexpr std::size_t kStrips = 32, kDirections = 16;  // as in the public header

struct StepGainsArgs {
  const double *x, *y, *residual;  // points
  std::size_t points;
  const double *ux, *uy;  // kDirections each
  std::size_t directions;
  double radius, per_metre, least_points;  // per_metre: strips
  const double* inverse;                   // a to f
  double* strips;                          // directions * kStrips * 4, zero; gets n, x, y, residual
  double *gain, *beyond;                   // directions * kStrips
};

struct StepGainsBody {
  void (*step_gains)(const StepGainsArgs&);
};
extern const Variants<StepGainsBody> kStepGains;

}  // namespace ilot::simd
