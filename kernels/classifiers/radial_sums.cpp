// SPDX-License-Identifier: Apache-2.0
#include "kernels/classifiers/radial_sums.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "kernels/classifiers/radial_sums_body.h"

namespace ilot {

void radial_sums(const RadialVectors& model, std::span<const double> rows, std::span<double> totals,
                 std::span<double> nearest) {
  using simd::kRadialRows;
  const std::size_t dimensions = model.dimensions, sums = model.sums;
  assert(dimensions > 0 && sums > 0);
  assert(rows.size() == nearest.size() * dimensions && totals.size() == nearest.size() * sums);
  assert(model.vectors.size() / dimensions == model.weights.size() / sums);
  std::vector<double> turned(dimensions * kRadialRows, 0), turned_totals(sums * kRadialRows);
  double turned_nearest[kRadialRows];
  for (std::size_t first = 0; first < nearest.size(); first += kRadialRows) {
    const std::size_t count = std::min(kRadialRows, nearest.size() - first);
    for (std::size_t r = 0; r < count; ++r)
      for (std::size_t i = 0; i < dimensions; ++i) turned[i * kRadialRows + r] = rows[(first + r) * dimensions + i];
    simd::kRadialSums.best().radial_sums({turned.data(), model.vectors.data(), model.weights.data(),
                                          model.vectors.size() / dimensions, dimensions, sums, model.gamma,
                                          turned_totals.data(), turned_nearest});
    for (std::size_t r = 0; r < count; ++r) {
      nearest[first + r] = turned_nearest[r];
      for (std::size_t s = 0; s < sums; ++s) totals[(first + r) * sums + s] = turned_totals[s * kRadialRows + r];
    }
  }
}

}  // namespace ilot
