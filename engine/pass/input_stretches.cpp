// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/input_stretches.h"

#include <algorithm>

namespace ilot {
namespace {

// Divides a range of a random-access file at the boundaries, about `most` rows apart.
void cut_range(const std::vector<std::uint64_t>& cuts, const RowRange& range, std::uint32_t file, std::uint64_t most,
               std::vector<InputStretch>& stretches) {
  std::uint64_t first = range.first;
  for (auto cut = std::upper_bound(cuts.begin(), cuts.end(), first); first < range.end; ++cut) {
    const bool last = *cut == range.end;
    if (!last && *(cut + 1) - first <= most) continue;
    stretches.push_back({file, first, *cut - first});
    first = *cut;
  }
}

std::uint64_t rows_of_stretch(const std::vector<std::unique_ptr<PointReader>>& inputs, std::uint64_t most) {
  constexpr std::uint64_t kLeast = 1 << 16, kLeastNumber = 16;
  std::uint64_t points = 0;
  for (const auto& input : inputs) points += input->info().points;
  return std::min(most, std::max(kLeast, points / kLeastNumber));
}

}  // namespace

std::vector<InputStretch> cut_inputs(const std::vector<std::unique_ptr<PointReader>>& inputs,
                                     std::span<const std::vector<RowRange>> rows, std::uint64_t most) {
  std::vector<InputStretch> stretches;
  const std::uint64_t length = rows_of_stretch(inputs, most);
  for (std::uint32_t f = 0; f < inputs.size(); ++f) {
    if (!inputs[f]->random_access()) {
      stretches.push_back({f, 0, inputs[f]->info().points});
      continue;
    }
    const std::vector<std::uint64_t> cuts = inputs[f]->boundaries();
    for (const RowRange& range : rows[f]) cut_range(cuts, range, f, length, stretches);
  }
  return stretches;
}

void limit_inputs(const std::vector<std::unique_ptr<PointReader>>& inputs, std::uint32_t fields) {
  for (const auto& input : inputs) input->limit_to(fields);
}

}  // namespace ilot
