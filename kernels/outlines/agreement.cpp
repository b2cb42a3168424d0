// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/agreement.h"

#include <algorithm>
#include <numeric>

namespace ilot {
namespace {

struct IntervalEnd {
  double at;
  int step;  // 1 where an interval begins, -1 where it ends
};

}  // namespace

Bounded agreement(std::span<const Bounded> measured) {
  std::vector<IntervalEnd> ends;
  for (const Bounded& m : measured) {
    ends.push_back({m.value - m.error, 1});
    ends.push_back({m.value + m.error, -1});
  }
  std::sort(ends.begin(), ends.end(),
            [](const IntervalEnd& a, const IntervalEnd& b) { return a.at != b.at ? a.at < b.at : a.step > b.step; });
  int depth = 0, deepest = 0;
  double low = 0, high = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    depth += ends[i].step;
    if (ends[i].step < 0 || depth < deepest) continue;
    const double until = ends[i + 1].at;  // a beginning is never the last
    if (depth == deepest && !(until - ends[i].at < high - low)) continue;
    deepest = depth;
    low = ends[i].at;
    high = until;
  }
  return {low + (high - low) / 2, (high - low) / 2};
}

std::vector<std::size_t> groups_of_equals(std::span<const double> values, double tolerance) {
  std::vector<std::size_t> order(values.size()), group(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
  std::size_t groups = 0;
  double first = 0;
  for (const std::size_t i : order) {
    if (groups == 0 || values[i] - first > tolerance) {
      first = values[i];
      ++groups;
    }
    group[i] = groups - 1;
  }
  return group;
}

}  // namespace ilot
