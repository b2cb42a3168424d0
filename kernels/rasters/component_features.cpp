// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/component_features.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "kernels/core/integers.h"

namespace ilot {
namespace {

struct Summary {
  double mean = 0, sd = 0, max = 0, min = 0, mode = 0;
};

// Finds the longest run of equal bins of sorted values, the first of equally long ones.
std::int64_t fullest_bin(std::span<const std::int64_t> sorted, std::int64_t bin) {
  std::size_t most = 0;
  std::int64_t best = 0;
  for (std::size_t from = 0; from < sorted.size();) {
    const std::int64_t b = floor_divided(sorted[from], bin);
    std::size_t to = from + 1;
    while (to < sorted.size() && sorted[to] < (b + 1) * bin) ++to;
    if (to - from > most) {
      most = to - from;
      best = b;
    }
    from = to;
  }
  return best;
}

// Squares are relative to the least value. They are integers, exact below 2^53.
Summary summary_of(std::span<std::int64_t> values, std::int64_t bin) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::int64_t low = values.front();
  double sum = 0, squares = 0;
  for (const std::int64_t v : values) {
    const auto above = static_cast<double>(v - low);
    sum += above;
    squares += above * above;
  }
  const auto n = static_cast<double>(values.size()), mean = sum / n;
  const double variance = std::max(0.0, squares / n - mean * mean);
  const auto mode = static_cast<double>(fullest_bin(values, bin) * bin) + 0.5 * static_cast<double>(bin - 1);
  return {static_cast<double>(low) + mean, std::sqrt(variance), static_cast<double>(values.back()),
          static_cast<double>(low), mode};
}

// Pixels grouped by label: those of label l from starts[l] to starts[l + 1].
struct Groups {
  std::vector<std::size_t> starts;
  std::vector<std::uint32_t> pixels;
};

Groups groups_of(const PixelLabels& labels) {
  Groups groups{std::vector<std::size_t>(std::size_t{labels.count} + 2, 0), {}};
  for (const std::uint32_t label : labels.of)
    if (label != 0) ++groups.starts[label + 1];
  for (std::size_t l = 1; l < groups.starts.size(); ++l) groups.starts[l] += groups.starts[l - 1];
  groups.pixels.resize(groups.starts.back());
  auto at = groups.starts;
  for (std::size_t i = 0; i < labels.of.size(); ++i)
    if (labels.of[i] != 0) groups.pixels[at[labels.of[i]]++] = static_cast<std::uint32_t>(i);
  return groups;
}

}  // namespace

const char* feature_name(ComponentFeature feature) {
  static constexpr const char* kNames[] = {"mean height",
                                           "s.d. height",
                                           "max height",
                                           "min height",
                                           "mode height",
                                           "mean accumulation",
                                           "s.d. accumulation",
                                           "max accumulation",
                                           "min accumulation",
                                           "mode accumulation",
                                           "area"};
  return kNames[static_cast<std::size_t>(feature)];
}

std::vector<ComponentFeatures> component_features(const PixelLabels& labels, const Image& heights,
                                                  std::span<const std::uint32_t> accumulation,
                                                  const ComponentFeaturesParams& params) {
  assert(labels.of.size() == heights.size() && accumulation.size() == heights.size() && params.mode_bin >= 1);
  const Groups groups = groups_of(labels);
  std::vector<ComponentFeatures> features(labels.count);
  std::vector<std::int64_t> h, a;
  for (std::uint32_t label = 1; label <= labels.count; ++label) {
    h.clear();
    a.clear();
    for (std::size_t i = groups.starts[label]; i < groups.starts[label + 1]; ++i) {
      assert(heights.values[groups.pixels[i]] != kNoHeight);
      h.push_back(heights.values[groups.pixels[i]]);
      a.push_back(accumulation[groups.pixels[i]]);
    }
    const Summary s = summary_of(h, params.mode_bin), t = summary_of(a, 1);
    const double u = params.unit, area = static_cast<double>(h.size()) * params.pixel * params.pixel;
    features[label - 1] = {s.mean * u, s.sd * u, s.max * u, s.min * u, s.mode * u, t.mean,
                           t.sd,       t.max,    t.min,     t.mode,    area};
  }
  return features;
}

}  // namespace ilot
