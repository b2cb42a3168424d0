// SPDX-License-Identifier: Apache-2.0
// Internal to the classifier of candidates: probabilities of many classes from those of pairs.
#pragma once
#include <cstddef>
#include <vector>

namespace ilot {

// The probabilities p of k >= 2 classes that fit those of the pairs best: they minimise the sum over pairs of (r_ba p_a
// - r_ab p_b)^2 with sum 1 (Wu, Lin and Weng 2004, second method). `first` has for each pair (0, 1), (0, 2) ... (1, 2)
// ... the probability of the first class, clamped to at least 1e-7 away from 0 and 1. The system is solved by
// elimination with pivots, O(k^3).
std::vector<double> coupled_pairs(const std::vector<double>& first, std::size_t k);

}  // namespace ilot
