// SPDX-License-Identifier: Apache-2.0
// Internal to the training: probabilities from decisions.
#pragma once
#include <cstdint>
#include <vector>

namespace ilot {

// The function 1 / (1 + exp(a f + b)).
struct Sigmoid {
  double a = -1, b = 0;
};

// Fits a sigmoid to decisions f and to whether the first class is true, by Newton's method with backtracking (Platt
// 1999 as Lin, Lin and Weng 2007 do it).
Sigmoid fit_sigmoid(const std::vector<double>& f, const std::vector<std::uint8_t>& first);

}  // namespace ilot
