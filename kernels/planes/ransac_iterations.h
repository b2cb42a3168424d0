// SPDX-License-Identifier: Apache-2.0
// How many draws a search by random samples needs [Marchand 2018, I.3.1.5]. Out of plain arithmetic, so the same number
// on every machine.
#pragma once
#include <cstdint>

namespace ilot {

constexpr std::uint64_t kMaxDraws = std::uint64_t{1} << 62;  // what an impossible sample is answered with

// Draws after which one with all members of a sample right has been seen with the probability given:
// log(1 - probability) / log(1 - q), rounded up, q = the chance of one draw. q <= 0: kMaxDraws; q >= 1: 1.
// probability in (0, 1).
std::uint64_t draws_for_probability(double chance, double probability);

// [Marchand 2018, I.3.1.5] N = log(1 - p) / log(1 - (1 - eps)^s): share of outliers eps, samples of s points.
std::uint64_t ransac_iterations(double outlier_share, int sample_size, double probability);

// The safety factor of Marchand 2018 for few draws: N (1 + ln N) / ln N for 2 <= N <= 10, rounded up; 3 becomes 6.
// Other numbers are returned as they are.
std::uint64_t with_safety_factor(std::uint64_t draws);

// What the sampler of a colour-guided search should do next [Lorraine thesis, 2.2.2]. Members of the consensus set
// among all points, and of the majority colour class of that set among all points of the class. While the share within
// the class is the larger one, sampling inside it needs fewer draws; the bound belongs to the sampler. O(1).
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
