// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/step_gains.h"

#include <algorithm>
#include <cassert>

#include "kernels/planes/step_gains_body.h"

namespace ilot {

static_assert(simd::kStrips == kStepStrips && simd::kDirections == kStepDirections);

void step_gains(const StepWindow& window, std::span<const StepDirection> directions, StepGains& out) {
  assert(directions.size() <= kStepDirections && window.radius > 0);
  assert(window.x.size() == window.y.size() && window.x.size() == window.residual.size());
  std::array<double, kStepDirections> ux{}, uy{};
  for (std::size_t k = 0; k < directions.size(); ++k) ux[k] = directions[k].x, uy[k] = directions[k].y;
  const PlaneInverse& m = window.inverse;
  const std::array<double, 6> inverse{m.a, m.b, m.c, m.d, m.e, m.f};
  std::array<double, kStepDirections * kStepStrips * 4> strips;  // n, x, y, residual
  std::fill_n(strips.begin(), directions.size() * kStepStrips * 4, 0.0);
  simd::kStepGains.best().step_gains({window.x.data(), window.y.data(), window.residual.data(), window.x.size(),
                                      ux.data(), uy.data(), directions.size(), window.radius,
                                      kStepStrips / (2 * window.radius), window.least_points, inverse.data(),
                                      strips.data(), out.gain.data(), out.residual.data()});
}

}  // namespace ilot
