// SPDX-License-Identifier: Apache-2.0
// Internal to the classifier of candidates: functions that training and use share.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/products/streets/classes/object_model.h"
#include "kernels/core/portable_math.h"

namespace ilot {

// The signed square root of a feature. Features span decades, and a difference counts less where the values are large.
inline double signed_root(double v) {
  return v < 0 ? -std::sqrt(-v) : std::sqrt(v);
}

inline std::vector<double> standardised(const ObjectModel& model, const CandidateFeatures& features) {
  std::vector<double> row;
  for (std::size_t i = 0; i < model.features.size(); ++i)
    row.push_back((signed_root(features[model.features[i]]) - model.mean[i]) / model.sd[i]);
  return row;
}

inline double radial(const std::vector<double>& a, const std::vector<double>& b, double gamma) {
  double d2 = 0;
  for (std::size_t i = 0; i < a.size(); ++i) d2 += (a[i] - b[i]) * (a[i] - b[i]);
  return natural_exp(std::max(-701.0, -gamma * d2));
}

// 1 / (1 + exp(v)).
inline double sigmoid(double v) {
  return v >= 0 ? natural_exp(-std::min(v, 701.0)) / (1 + natural_exp(-std::min(v, 701.0)))
                : 1 / (1 + natural_exp(std::max(v, -701.0)));
}

// The logarithm of the odds of a probability, which is kept from 0 and 1.
inline double log_odds(double p) {
  constexpr double kLeast = 1e-6;  // Derived: below one object in those that models are trained on
  const double kept = std::min(std::max(p, kLeast), 1 - kLeast);
  return natural_log(kept) - natural_log(1 - kept);
}

// The index of the pair (a, b), a < b, of k classes.
inline std::size_t pair_index(std::size_t a, std::size_t b, std::size_t k) {
  return a * k - a * (a + 1) / 2 + b - a - 1;
}

// The class that wins most pairs (ties: the first).
inline std::size_t voted(const std::vector<double>& decisions, std::size_t k) {
  std::vector<int> votes(k, 0);
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = a + 1; b < k; ++b) ++votes[decisions[pair_index(a, b, k)] > 0 ? a : b];
  return static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

// The logarithms of the shares of the states, before the weights are applied.
std::array<double, kCandidateStates> state_logs(const KindShares& shares);

// For each candidate the class with the greatest share.
std::vector<PointLabel> most_probable_classes(const ObjectModel& model, std::span<const CandidateFeatures> candidates);

}  // namespace ilot
