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

// Samples in [-1, 1] about an edge anywhere in it; each is on the wrong side with a chance.
struct SampledEdge {
  double edge = 0;
  std::vector<double> below, above;
};

SampledEdge sampled_edge(std::uint64_t seed, int count, double wrong) {
  Rng rng(seed);
  SampledEdge s;
  s.edge = 2 * rng.uniform() - 1;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * rng.uniform() - 1;
    const bool below = (t < s.edge) != (rng.uniform() < wrong);
    (below ? s.below : s.above).push_back(t);
  }
  return s;
}

// Coverage by binomial bounds: of 1,000 edges 950 lie within, four standard deviations are 27.6. Few samples say little
// of how often they are wrong, so their ranges are a little too wide.
TEST(EdgeRange, ContainsNineteenEdgesOfTwenty) {
  for (const int count : {10, 30, 100, 300})
    for (const double wrong : {0.0, 0.02, 0.1}) {
      int within = 0;
      for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const SampledEdge s = sampled_edge(1000 * static_cast<std::uint64_t>(count) + seed, count, wrong);
        const EdgeRange range = edge_range(s.below, s.above, -1, 1);
        within += s.edge >= range.from && s.edge <= range.to;
      }
      EXPECT_GE(within, 922) << count << " " << wrong;
      EXPECT_LE(within, count < 100 ? 995 : 978) << count << " " << wrong;
    }
}

TEST(EdgeRange, AGapThatIsNarrowByChancePromisesNoMoreThanTheNextSamples) {
  std::vector<double> below, above;
  for (int i = 0; i < 10; ++i) below.push_back(-0.1 * i - 0.1), above.push_back(0.1 * i + 0.1);
  below.push_back(0.0499);
  above.push_back(0.0501);
  EXPECT_LT(split_edge(below, above).half_gap, 0.0002);
  const EdgeRange range = edge_range(below, above, -1, 1);
  EXPECT_LT(range.from, 0.0);
  EXPECT_GT(range.to, 0.09);
  EXPECT_LT(range.to - range.from, 0.4);
}

TEST(EdgeRange, WithoutSamplesAnythingIsPossible) {
  const std::vector<double> none;
  const EdgeRange range = edge_range(none, none, 2, 4);
  EXPECT_NEAR(range.from, 2.05, 1e-12);
  EXPECT_NEAR(range.to, 3.95, 1e-12);
}

}  // namespace
}  // namespace ilot
