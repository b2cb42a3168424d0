// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/run_neighbours.h"

#include <algorithm>

#include "kernels/neighbours/knn.h"

namespace ilot {

RunNeighbours::RunNeighbours(std::size_t points, const NeighbourLists& neighbours)
    : runs_((points + kRun - 1) / kRun), first_{0} {
  std::vector<std::uint32_t> met_by(runs_, kNoNeighbour);
  for (std::uint32_t run = 0; run < runs_; ++run) {
    met_by[run] = run;
    const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(points, std::size_t{run} * kRun + kRun));
    for (std::uint32_t i = run * kRun; i < end; ++i)
      for (const std::uint32_t j : neighbours.of(i)) {
        if (j == kNoNeighbour || met_by[j / kRun] == run) continue;
        met_by[j / kRun] = run;
        others_.push_back(j / kRun);
      }
    first_.push_back(others_.size());
  }
}

std::vector<std::uint8_t> uniform_runs(const RunNeighbours& runs, std::span<const std::uint32_t> label) {
  constexpr std::uint32_t kMixed = 0xffffffffu;
  std::vector<std::uint32_t> only(runs.count());
  for (std::size_t r = 0; r < only.size(); ++r) {
    const auto part = label.subspan(r * RunNeighbours::kRun);
    const auto own = part.first(std::min<std::size_t>(part.size(), RunNeighbours::kRun));
    only[r] = std::all_of(own.begin(), own.end(), [&](std::uint32_t l) { return l == own[0]; }) ? own[0] : kMixed;
  }
  std::vector<std::uint8_t> quiet(only.size());
  for (std::size_t r = 0; r < only.size(); ++r) {
    const auto around = runs.around(r);
    quiet[r] = only[r] != kMixed &&
               std::all_of(around.begin(), around.end(), [&](std::uint32_t o) { return only[o] == only[r]; });
  }
  return quiet;
}

std::vector<std::uint8_t> unaffected_runs(const RunNeighbours& runs, std::span<const std::uint32_t> set) {
  std::vector<std::uint8_t> in_set(runs.count(), 0), quiet(runs.count());
  for (const std::uint32_t i : set) in_set[i / RunNeighbours::kRun] = 1;
  for (std::size_t r = 0; r < quiet.size(); ++r) {
    const auto around = runs.around(r);
    quiet[r] = !in_set[r] && std::none_of(around.begin(), around.end(), [&](std::uint32_t o) { return in_set[o]; });
  }
  return quiet;
}

}  // namespace ilot
