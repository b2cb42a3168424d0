// SPDX-License-Identifier: Apache-2.0
// The number of draws that a search by random samples needs [Marchand 2018, I.3.1.5]. The functions use plain
// arithmetic, so the number is the same on every machine.
#pragma once
#include <cstdint>

namespace ilot {

constexpr std::uint64_t kMaxDraws = std::uint64_t{1} << 62;  // the result for an impossible sample

// Returns the number of draws after which, with the given probability, at least one draw had only correct members:
// log(1 - probability) / log(1 - q), rounded up, where q is the chance of one draw. The result is kMaxDraws for q <= 0
// and 1 for q >= 1. probability is in (0, 1).
std::uint64_t draws_for_probability(double chance, double probability);

// [Marchand 2018, I.3.1.5] N = log(1 - p) / log(1 - (1 - eps)^s), with the share of outliers eps and samples of s
// points.
std::uint64_t ransac_iterations(double outlier_share, int sample_size, double probability);

// The safety factor of Marchand 2018 for few draws: N (1 + ln N) / ln N for 2 <= N <= 10, rounded up. For example 3
// becomes 6. Other numbers are returned unchanged.
std::uint64_t with_safety_factor(std::uint64_t draws);

// Decides the next step of the sampler of a colour-guided search [Lorraine thesis, 2.2.2]. The input is the number of
// members of the consensus set among all points, and of members of its majority colour class among all points of the
// class. While the share within the class is larger, sampling inside it needs fewer draws. The bound belongs to the
// sampler. O(1).
struct ColourShares {
  std::uint64_t consensus = 0, points = 0;
  std::uint64_t class_consensus = 0, class_points = 0;
};
struct SamplingPlan {
  enum class From { kAll, kClass } from = From::kAll;
  std::uint64_t draws = kMaxDraws;  // kappa, or kappa' inside the class
};
SamplingPlan plan_sampling(const ColourShares& shares, double probability);

}  // namespace ilot
