// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/edge_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Every place between two samples tried.
std::size_t fewest_wrong(const std::vector<double>& below, const std::vector<double>& above) {
  std::vector<double> all = below;
  all.insert(all.end(), above.begin(), above.end());
  std::sort(all.begin(), all.end());
  std::size_t fewest = all.size() + 1;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const double t = (all[i] + all[i + 1]) / 2;
    const auto high = std::count_if(below.begin(), below.end(), [&](double v) { return v > t; });
    const auto low = std::count_if(above.begin(), above.end(), [&](double v) { return v < t; });
    fewest = std::min(fewest, static_cast<std::size_t>(high + low));
  }
  return fewest;
}

TEST(EdgeSplit, MiddleOfTheGap) {
  const std::vector<double> below{0.1, 0.4, 0.3}, above{0.9, 0.5, 0.7};
  const EdgeSplit split = split_edge(below, above);
  EXPECT_TRUE(split.found);
  EXPECT_DOUBLE_EQ(split.at, 0.45);
  EXPECT_NEAR(split.half_gap, 0.05, 1e-12);
  EXPECT_EQ(split.wrong, 0u);
}

TEST(EdgeSplit, OneSideAloneGivesNoEdge) {
  const std::vector<double> some{1, 2}, none;
  EXPECT_FALSE(split_edge(some, none).found);
  EXPECT_FALSE(split_edge(none, some).found);
}

TEST(EdgeSplit, StraysAreOutvoted) {
  std::vector<double> below, above;
  for (int i = 0; i < 100; ++i) {
    below.push_back(-0.01 * i);
    above.push_back(0.02 + 0.01 * i);
  }
  below.push_back(0.5);
  above.push_back(-0.3);
  const EdgeSplit split = split_edge(below, above);
  EXPECT_NEAR(split.at, 0.01, 1e-12);
  EXPECT_EQ(split.wrong, 2u);
}

TEST(EdgeSplit, AsGoodAsEveryPlaceTried) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    std::vector<double> below, above;
    for (int i = 0; i < 30; ++i) {
      below.push_back(rng.uniform());
      above.push_back(0.6 * rng.uniform() + 0.5);
    }
    const EdgeSplit split = split_edge(below, above);
    EXPECT_EQ(split.wrong, fewest_wrong(below, above)) << seed;
    std::reverse(below.begin(), below.end());
    EXPECT_EQ(split_edge(below, above).at, split.at) << seed;
  }
}

}  // namespace
}  // namespace ilot
