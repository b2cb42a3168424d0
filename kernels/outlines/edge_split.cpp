// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/edge_split.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ilot {
namespace {

struct Sample {
  double at;
  bool below;
};

std::vector<Sample> sorted_samples(std::span<const double> below, std::span<const double> above) {
  std::vector<Sample> samples;
  samples.reserve(below.size() + above.size());
  for (const double t : below) samples.push_back({t, true});
  for (const double t : above) samples.push_back({t, false});
  // Of equal places the lower side comes first, so that a split there has both on their own side.
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.at != b.at ? a.at < b.at : a.below && !b.below; });
  return samples;
}

// The place up to which `share` of the weight of the gaps lies; each gap has its weight evenly.
double place_of_share(const std::vector<double>& ends, const std::vector<double>& weights, double share) {
  double all = 0, before = 0;
  for (const double w : weights) all += w;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0 && before + weights[i] >= share * all)
      return ends[i] + (ends[i + 1] - ends[i]) * (share * all - before) / weights[i];
    before += weights[i];
  }
  return ends.back();
}

}  // namespace

EdgeSplit split_edge(std::span<const double> below, std::span<const double> above) {
  if (below.empty() || above.empty()) return {};
  const std::vector<Sample> samples = sorted_samples(below, above);
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

EdgeRange edge_range(std::span<const double> below, std::span<const double> above, double from, double to) {
  constexpr double kTail = 0.025;  // Derived: 95 % between both ends
  std::vector<Sample> samples = sorted_samples(below, above);
  std::erase_if(samples, [&](const Sample& s) { return s.at < from || s.at > to; });
  std::vector<double> ends{from}, wrong{0};
  for (const Sample& s : samples) wrong[0] += s.below;
  for (const Sample& s : samples) {
    ends.push_back(s.at);
    wrong.push_back(wrong.back() + (s.below ? -1 : 1));
  }
  ends.push_back(to);
  const double least = *std::min_element(wrong.begin(), wrong.end());
  const double chance = std::min(0.5, (least + 1) / (static_cast<double>(samples.size()) + 2));
  // Powers by multiplication: those of the library differ between machines.
  std::vector<double> likely{1};
  const double most = *std::max_element(wrong.begin(), wrong.end()) - least;
  while (static_cast<double>(likely.size()) <= most) likely.push_back(likely.back() * (chance / (1 - chance)));
  std::vector<double> weights;
  for (std::size_t i = 0; i < wrong.size(); ++i)
    weights.push_back((ends[i + 1] - ends[i]) * likely[static_cast<std::size_t>(wrong[i] - least)]);
  return {place_of_share(ends, weights, kTail), place_of_share(ends, weights, 1 - kTail)};
}

}  // namespace ilot
