// SPDX-License-Identifier: Apache-2.0
// How far stated probabilities of objects hold.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace ilot {

// Stated probabilities in tenths, against how many are right (Guo, Pleiss, Sun and Weinberger 2017).
struct Stated {
  struct Bin {
    std::uint64_t count = 0, right = 0;
    double sum = 0;
  };
  std::array<Bin, 10> bins;

  void add(double probability, bool right);
};
using StatedOf = std::map<std::string, Stated>;  // by class, and "all"

// Prints the number of objects, the calibration error, and what was stated and right, where there is an object.
void print_stated(const std::string& of, const Stated& stated);

}  // namespace ilot
