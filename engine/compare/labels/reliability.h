// SPDX-License-Identifier: Apache-2.0
// Judges probabilities: of all statements with a probability of 0.8, eight in ten should be right. [Niculescu-Mizil and
// Caruana 2005; the error as Guo, Pleiss, Sun and Weinberger 2017]
#pragma once
#include <array>
#include <cstdint>
#include <span>

namespace ilot {

struct JudgedProbability {
  double probability = 0;  // 0 to 1
  bool right = false;
};

struct ReliabilityBin {
  std::uint64_t count = 0;
  double mean_probability = 0;  // 0 in an empty bin
  double right = 0;             // share; 0 in an empty bin
};

struct Reliability {
  std::array<ReliabilityBin, 10> bins;  // of equal width; a probability on a border is in the upper one, 1 in the last
  std::uint64_t count = 0;
  double calibration_error = 0;  // ECE: mean over all statements of |right - mean probability| of their bin
};

// O(n). Empty without statements.
Reliability reliability(std::span<const JudgedProbability> statements);

}  // namespace ilot
