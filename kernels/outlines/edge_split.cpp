// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/edge_split.h"

#include <algorithm>
#include <vector>

namespace ilot {
namespace {

struct Sample {
  double at;
  bool below;
};

}  // namespace

EdgeSplit split_edge(std::span<const double> below, std::span<const double> above) {
  if (below.empty() || above.empty()) return {};
  std::vector<Sample> samples;
  samples.reserve(below.size() + above.size());
  for (const double t : below) samples.push_back({t, true});
  for (const double t : above) samples.push_back({t, false});
  // Of equal places the lower side comes first, so that a split there has both on their own side.
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.at != b.at ? a.at < b.at : a.below && !b.below; });
  std::size_t wrong = below.size(), least = samples.size() + 1;
  double widest = -1;
  EdgeSplit best;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    wrong = samples[i].below ? wrong - 1 : wrong + 1;
    const double gap = samples[i + 1].at - samples[i].at;
    if (wrong > least || (wrong == least && !(gap > widest))) continue;
    least = wrong;
    widest = gap;
    best = {samples[i].at + gap / 2, gap / 2, wrong, true};
  }
  return best;
}

}  // namespace ilot
