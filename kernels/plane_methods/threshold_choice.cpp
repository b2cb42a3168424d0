// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/threshold_choice.h"

#include <cassert>

#include "kernels/core/portable_math.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/refine.h"

namespace ilot {
namespace {

// Derived: below every share.
constexpr double kNothing = -1;  // no consensus

double mse_of(const OrientedPoints& points, std::span<const std::uint32_t> candidates, const Plane& start,
              double epsilon, double min_cos) {
  const RefinedPlane r = refine_plane(points, candidates, start, {epsilon, min_cos});
  if (r.members.size() < 3) return kNothing;
  const double rms = rms_to_plane(moments_of(points.points, r.members), r.plane);
  return rms * rms;
}

}  // namespace

std::optional<std::size_t> knee_of(std::span<const double> x, std::span<const double> y, double least_bend) {
  assert(x.size() == y.size());
  if (x.size() < 3) return std::nullopt;
  const double range = x.back() - x.front();
  const double mean_slope = (y.back() - y.front()) / range;
  std::optional<std::size_t> knee;
  double most = least_bend * (mean_slope < 0 ? -mean_slope : mean_slope) / range;
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const double before = (y[i] - y[i - 1]) / (x[i] - x[i - 1]), after = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    const double bend = 2 * (after - before) / (x[i + 1] - x[i - 1]);
    if (!(bend > most)) continue;
    most = bend;
    knee = i;
  }
  return knee;
}

ThresholdSweep choose_distance(const OrientedPoints& points, std::span<const std::uint32_t> candidates,
                               const Plane& start, double noise, double min_cos) {
  constexpr int kSteps = 18;
  ThresholdSweep sweep;
  for (int i = 0; i <= kSteps; ++i) {
    const double delta = noise * (2 + 0.5 * i);
    const double mse = mse_of(points, candidates, start, delta, min_cos);
    if (mse == kNothing) continue;
    sweep.value.push_back(delta);
    sweep.mse.push_back(mse);
  }
  const auto knee = knee_of(sweep.value, sweep.mse);
  sweep.found = knee.has_value();
  sweep.chosen = knee ? sweep.value[*knee] : 3 * noise;
  return sweep;
}

ThresholdSweep choose_angle(const OrientedPoints& points, std::span<const std::uint32_t> candidates, const Plane& start,
                            double epsilon) {
  constexpr int kSteps = 26;
  ThresholdSweep sweep;
  sweep.chosen = 40;
  double least = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double beta = 10 + 2.5 * i;
    const double mse = mse_of(points, candidates, start, epsilon, cos_degrees(beta));
    if (mse == kNothing) continue;
    sweep.value.push_back(beta);
    sweep.mse.push_back(mse);
    if (sweep.found && mse > least) continue;
    least = mse;
    sweep.chosen = beta;
    sweep.found = true;
  }
  return sweep;
}

}  // namespace ilot
