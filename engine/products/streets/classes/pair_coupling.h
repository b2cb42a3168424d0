// SPDX-License-Identifier: Apache-2.0
// Inside of the things' machine: probabilities of many classes from those of pairs.
#pragma once
#include <cstddef>
#include <vector>

namespace ilot {

// Probabilities p of k >= 2 classes that fit those of pairs best: the least sum over pairs of (r_ba p_a - r_ab p_b)^2
// with sum 1 (Wu, Lin and Weng 2004, second method). `first`: of each pair (0, 1), (0, 2) ... (1, 2) ... how probable
// the first is, brought to 1e-7 from 0 and 1. Elimination with pivots, O(k^3).
std::vector<double> coupled_pairs(const std::vector<double>& first, std::size_t k);

}  // namespace ilot
