// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/density_step.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Derived: e^-3 is 1/20; with this 95 to 97 of 100 made steps are within the range, for 40 to 1,000 points and
// densities that differ by 2.5 to 20 times.
constexpr double kNearlyAsLikely = 3;  // natural logarithm
constexpr double kMargin = 0.05;       // Choice: fewer points than in a twentieth of the range say nothing of a density

double log_likelihood(double count, double length) {
  return count > 0 ? count * natural_log(count / length) : 0;
}

}  // namespace

DensityStep density_step(std::span<const double> places, double from, double to) {
  const double all = static_cast<double>(places.size()), margin = kMargin * (to - from);
  const auto is_tried = [&](double at) { return at >= from + margin && at <= to - margin; };
  const auto likelihood = [&](std::size_t i) {
    const double below = static_cast<double>(i);
    return log_likelihood(below, places[i] - from) + log_likelihood(all - below, to - places[i]);
  };
  DensityStep step;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!is_tried(places[i])) continue;
    const double value = likelihood(i);
    if (step.found && value <= step.likelihood) continue;
    step.found = true;
    step.at = places[i], step.likelihood = value;
    step.below = static_cast<double>(i) / (places[i] - from);
    step.above = (all - static_cast<double>(i)) / (to - places[i]);
  }
  if (!step.found) return step;
  step.low = step.high = step.at;
  std::size_t first = places.size();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!is_tried(places[i]) || likelihood(i) < step.likelihood - kNearlyAsLikely) continue;
    first = std::min(first, i);
    step.high = places[i];
  }
  // From a point down to the one before it the likelihood falls as the denser side gets longer.
  const double gap = first > 0 ? places[first] - places[first - 1] : places[first] - from;
  const double slack = kNearlyAsLikely - (step.likelihood - likelihood(first));
  step.low = places[first] - std::min(gap, step.above > step.below ? slack / (step.above - step.below) : gap);
  step.likelihood -= log_likelihood(all, to - from);
  return step;
}

}  // namespace ilot
