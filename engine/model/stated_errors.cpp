// SPDX-License-Identifier: Apache-2.0
#include "engine/model/stated_errors.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ilot {

double seen_error_95(const Facade& facade) {
  constexpr double kShare = 0.95, kBound = 1.959964;  // standard deviations that contain this share of normal errors
  constexpr int kHalvings = 40;                       // of 3 m: far below a micrometre
  std::vector<double> errors;
  for (const FacadeElement& e : facade.elements)
    for (const FacadeEdge& edge : e.edges)
      if (edge.status == DrawnStatus::seen && edge.error_m > 0) errors.push_back(edge.error_m);
  if (errors.empty()) return 0;
  const auto expected_within = [&](double limit) {
    double sum = 0;
    for (const double error : errors) sum += std::erf(limit * kBound / (error * std::sqrt(2.0)));
    return sum / static_cast<double>(errors.size());
  };
  const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
  double low = *least, high = *most;
  for (int i = 0; i < kHalvings && low < high; ++i) {
    const double middle = (low + high) / 2;
    (expected_within(middle) < kShare ? low : high) = middle;
  }
  return high;
}

}  // namespace ilot
