// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/row_values.h"

namespace ilot {

std::vector<RowStretch> row_stretches(const std::vector<std::unique_ptr<PointReader>>& inputs,
                                      const std::function<bool(std::size_t)>& wanted) {
  constexpr std::uint64_t kLeast = 1 << 19;  // rows in a file, except in the last one
  std::vector<RowStretch> all;
  for (std::size_t f = 0; f < inputs.size(); ++f) {
    const std::uint64_t points = inputs[f]->info().points;
    if (!wanted(f) || points == 0) continue;
    if (!inputs[f]->random_access()) {
      all.push_back({f, 0, points});
      continue;
    }
    std::uint64_t first = 0;
    for (const std::uint64_t cut : inputs[f]->boundaries()) {
      if (cut - first < kLeast && cut != points) continue;
      if (cut > first) all.push_back({f, first, cut - first});
      first = cut;
    }
  }
  return all;
}

}  // namespace ilot
