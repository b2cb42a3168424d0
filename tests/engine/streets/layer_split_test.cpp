// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/layer_split.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

struct Parts {
  Image heights = filled_image(40, 30, kNoHeight);
  PixelLabels labels{40, 30, 0, std::vector<std::uint32_t>(1200, 0)};

  void stand(std::uint32_t label, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height,
             Height z) {
    labels.count = std::max(labels.count, label);
    for (std::uint32_t v = y; v < y + height; ++v)
      for (std::uint32_t u = x; u < x + width; ++u) {
        heights.values[v * 40 + u] = z + static_cast<Height>((u + v) % 3) * 20;
        labels.of[v * 40 + u] = label;
      }
  }
};

std::uint32_t at(const SplitLayers& s, std::uint32_t x, std::uint32_t y) {
  return s.labels.of[y * 40 + x];
}

TEST(LayerSplit, BollardBesideSomebody) {
  Parts parts;
  parts.stand(1, 2, 2, 9, 6, 1700);
  parts.stand(1, 11, 3, 4, 4, 950);
  parts.stand(2, 25, 5, 10, 8, 1400);  // one layer
  const SplitLayers got = split_layers(parts.labels, parts.heights, 10);
  ASSERT_EQ(got.layers.size(), 1u);
  EXPECT_EQ(got.layers[0], (std::pair{1u, 2u}));
  EXPECT_EQ(got.labels.count, 3u);
  EXPECT_EQ(at(got, 5, 4), 1u);
  EXPECT_EQ(at(got, 12, 4), 2u);
  EXPECT_EQ(at(got, 30, 8), 3u);
  EXPECT_EQ(at(got, 0, 0), 0u);
}

TEST(LayerSplit, ASlopeIsOneAndAStepInItTwo) {
  Parts parts;
  parts.stand(1, 5, 4, 20, 20, 0);
  const auto slope = [&](Height step) {
    for (std::uint32_t i = 0; i < 1200; ++i)
      if (parts.labels.of[i] != 0)
        parts.heights.values[i] = static_cast<Height>(300 + 30 * (i % 40 + i / 40)) + (i % 40 >= 15 ? step : 0);
    return split_layers(parts.labels, parts.heights, 10).layers.size();
  };
  EXPECT_EQ(slope(0), 0u);
  EXPECT_EQ(slope(1500), 1u);
}

TEST(LayerSplit, NeitherLayerIsSmallerThanTheLeast) {
  Parts parts;
  parts.stand(1, 2, 2, 9, 6, 1700);
  parts.stand(1, 11, 3, 4, 4, 950);
  EXPECT_EQ(split_layers(parts.labels, parts.heights, 16).layers.size(), 1u);
  EXPECT_TRUE(split_layers(parts.labels, parts.heights, 17).layers.empty());
  Parts two;  // the lower class in two pieces of 12
  two.stand(1, 5, 5, 10, 6, 1700);
  two.stand(1, 2, 5, 3, 4, 950);
  two.stand(1, 15, 5, 3, 4, 950);
  const SplitLayers got = split_layers(two.labels, two.heights, 12);
  ASSERT_EQ(got.layers.size(), 1u);
  EXPECT_EQ(at(got, 3, 6), 2u);
  EXPECT_EQ(at(got, 16, 6), 1u);  // one piece is the lower layer, all else the upper
  EXPECT_TRUE(split_layers(two.labels, two.heights, 13).layers.empty());
}

TEST(LayerSplit, FlatPartsAndNone) {
  Parts parts;
  EXPECT_EQ(split_layers(parts.labels, parts.heights, 0).labels.count, 0u);
  EXPECT_EQ(split_layers({}, {}, 5).labels.count, 0u);
  parts.labels.count = 1;
  for (std::uint32_t i = 200; i < 240; ++i) parts.labels.of[i] = 1, parts.heights.values[i] = 700;
  const SplitLayers got = split_layers(parts.labels, parts.heights, 0);
  EXPECT_TRUE(got.layers.empty());
  EXPECT_EQ(got.labels.of, parts.labels.of);
}

// By trying all limits, on random heights of one part.
TEST(LayerSplit, TheLimitIsTheBest) {
  Rng rng(5, 1);
  std::size_t split = 0;
  for (int round = 0; round < 60; ++round) {
    Parts parts;
    const std::uint32_t n = 12 + static_cast<std::uint32_t>(rng.below(25));
    parts.stand(1, 0, 0, n, 1, 0);
    std::vector<Height> values;
    for (std::uint32_t i = 0; i < n; ++i)
      values.push_back(parts.heights.values[i] = static_cast<Height>(rng.below(9) * 100 + (i < n / 2 ? 700 : 0)));
    double best = 0, mean = 0, all = 0;
    for (const Height v : values) mean += static_cast<double>(v) / n;
    for (const Height v : values) all += (v - mean) * (v - mean);
    for (Height limit = 100; limit <= 1500; limit += 100) {
      double low = 0, count = 0, high = 0;
      for (const Height v : values) (v < limit ? low : high) += v, count += v < limit;
      if (count == 0 || count == n) continue;
      const double apart = low / count - high / (n - count);
      best = std::max(best, count * (n - count) / n * apart * apart);
    }
    const bool expected = best > 0.75 * all * (1 + 1e-9);
    const SplitLayers got = split_layers(parts.labels, parts.heights, 1);
    if (std::abs(best - 0.75 * all) > 1e-6 * all) EXPECT_EQ(!got.layers.empty(), expected);
    split += !got.layers.empty();
  }
  EXPECT_GT(split, 5u);
  EXPECT_LT(split, 55u);
}

}  // namespace
}  // namespace ilot
