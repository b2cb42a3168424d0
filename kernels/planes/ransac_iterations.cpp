// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/ransac_iterations.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Returns ln(1 - q) for 0 < q < 1. The series keeps the digits that 1 - q loses.
double log_of_complement(double q) {
  if (q > 0x1p-10) return natural_log(1 - q);
  double power = q, sum = 0;
  for (int i = 1; i <= 6; ++i) {
    sum += power / i;
    power *= q;
  }
  return -sum;
}

std::uint64_t rounded_up(double v) {
  return v < static_cast<double>(kMaxDraws) ? static_cast<std::uint64_t>(std::ceil(v)) : kMaxDraws;
}

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

std::uint64_t draws_for_probability(double chance, double probability) {
  assert(probability > 0 && probability < 1);
  if (!(chance > 0)) return kMaxDraws;
  if (chance >= 1) return 1;
  const double wrong = log_of_complement(chance);
  return wrong < 0 ? std::max<std::uint64_t>(1, rounded_up(log_of_complement(probability) / wrong)) : kMaxDraws;
}

std::uint64_t ransac_iterations(double outlier_share, int sample_size, double probability) {
  double chance = 1;
  for (int i = 0; i < sample_size; ++i) chance *= 1 - outlier_share;
  return draws_for_probability(chance, probability);
}

std::uint64_t with_safety_factor(std::uint64_t draws) {
  if (draws < 2 || draws > 10) return draws;
  const double n = static_cast<double>(draws), log = natural_log(n);
  return rounded_up(n * (1 + log) / log);
}

SamplingPlan plan_sampling(const ColourShares& shares, double probability) {
  const double all = share(shares.consensus, shares.points);
  const double within = share(shares.class_consensus, shares.class_points);
  const bool guided = within > all;
  const double q = guided ? within : all;
  return {guided ? SamplingPlan::From::kClass : SamplingPlan::From::kAll,
          draws_for_probability(q * q * q, probability)};
}

}  // namespace ilot
