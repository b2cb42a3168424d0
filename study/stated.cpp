// SPDX-License-Identifier: Apache-2.0
#include "study/stated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ilot {

void Stated::add(double probability, bool right) {
  Bin& b = bins[std::min<std::size_t>(9, static_cast<std::size_t>(10 * probability))];
  ++b.count, b.right += right, b.sum += probability;
}

void print_stated(const std::string& of, const Stated& stated) {
  std::uint64_t count = 0, right = 0;
  double error = 0, sum = 0;
  for (const Stated::Bin& b : stated.bins) {
    count += b.count, right += b.right, sum += b.sum;
    error += std::abs(b.sum - static_cast<double>(b.right));
  }
  if (count == 0) return;
  const auto n = static_cast<double>(count);
  fmt::print("  probabilities of {}: {} objects, calibration error {:.3f}, stated {:.3f}, right {:.3f};", of, count,
             error / n, sum / n, static_cast<double>(right) / n);
  fmt::print(" of {} with 0.9 and more {} right\n", stated.bins[9].count, stated.bins[9].right);
}

}  // namespace ilot
