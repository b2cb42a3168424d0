// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/step_offset.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace ilot {
namespace {

struct Range {
  double low = 0, high = 0;
};

// The range where most of the gaps overlap.
Range most_overlap(std::span<const StepGap> gaps) {
  std::vector<std::pair<double, int>> ends;  // at one place, gaps open before others close
  for (const StepGap& g : gaps) {
    ends.emplace_back(std::min(g.upper, g.lower), -1);
    ends.emplace_back(std::max(g.upper, g.lower), 1);
  }
  std::sort(ends.begin(), ends.end());
  Range best;
  int open = 0, most = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    open -= ends[i].second;
    if (ends[i].second > 0 || ends[i + 1].second < 0) continue;  // not the innermost range
    const Range here{ends[i].first, ends[i + 1].first};
    if (open < most || (open == most && here.high - here.low <= best.high - best.low)) continue;
    most = open;
    best = here;
  }
  return best;
}

}  // namespace

double step_offset(std::span<const StepGap> gaps, double spacing) {
  if (gaps.empty()) return 0;
  const Range range = most_overlap(gaps);
  const auto rising = std::count_if(gaps.begin(), gaps.end(), [](const StepGap& g) { return g.upper > g.lower; });
  const double beyond = std::min((range.high - range.low) / 2, spacing);
  return 2 * rising > static_cast<std::ptrdiff_t>(gaps.size()) ? range.high - beyond : range.low + beyond;
}

}  // namespace ilot
