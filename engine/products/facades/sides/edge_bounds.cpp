// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/sides/edge_bounds.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {

double blur_at(std::span<const double> inside, std::span<const double> outside, double split, double within) {
  constexpr double kFew = 0.05;  // Derived: the two-sided 5 % of a test
  std::vector<double> wrong;
  double all = 0;
  for (const double t : inside) {
    all += std::abs(t - split) <= within;
    if (t > split && t - split <= within) wrong.push_back(t - split);
  }
  for (const double t : outside) {
    all += std::abs(t - split) <= within;
    if (t < split && split - t <= within) wrong.push_back(split - t);
  }
  return wrong.empty() || static_cast<double>(wrong.size()) < kFew * all ? 0 : upper_median(wrong);
}

double farthest_from(const EdgeSplit& split, const EdgeRange& range) {
  return std::max(split.at - range.from, range.to - split.at);
}

double half_of_relief(std::span<const double> before, std::size_t outside, const EdgeSplit& split, double at) {
  constexpr std::size_t kFewest = 2;  // Choice: one may be a stray point
  std::vector<double> hiding;
  for (const double t : before)
    if (std::abs(t - split.at) < split.half_gap) hiding.push_back(t);
  if (hiding.size() < kFewest || static_cast<double>(hiding.size()) < kHiding * static_cast<double>(outside)) return 0;
  return std::max(0.0, at - lower_quantile(hiding, kTailOfEnds)) / 2;
}

}  // namespace ilot
