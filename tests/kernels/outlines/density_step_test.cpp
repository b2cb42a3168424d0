// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/density_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Points that fall independently: `below` of them in [from, at) and `above` in [at, to].
std::vector<double> points_about(double at, int below, int above, double from, double to, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<double> places;
  for (int i = 0; i < below; ++i) places.push_back(from + (at - from) * rng.uniform());
  for (int i = 0; i < above; ++i) places.push_back(at + (to - at) * rng.uniform());
  std::sort(places.begin(), places.end());
  return places;
}

TEST(DensityStep, TheTruePlaceIsInTheRangeInNineteenOfTwenty) {
  constexpr int kDraws = 400;
  for (const int below : {4, 15, 35}) {
    SCOPED_TRACE(below);
    int within = 0;
    for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
      const DensityStep step = density_step(points_about(0.1, 2 * below, 90, -0.3, 0.3, seed), -0.3, 0.3);
      ASSERT_TRUE(step.found);
      within += step.low <= 0.1 && 0.1 <= step.high;
      EXPECT_LE(step.low, step.at);
      EXPECT_GE(step.high, step.at);
      EXPECT_LT(step.below, step.above);
    }
    EXPECT_GE(within, 0.93 * kDraws);
    EXPECT_LE(within, 0.99 * kDraws);
  }
}

TEST(DensityStep, OneDensityIsNoStep) {
  int likely = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed)
    likely += density_step(points_about(0, 50, 50, -0.3, 0.3, seed), -0.3, 0.3).likelihood > 8;
  EXPECT_LE(likely, 4);  // the best of some hundred places
}

double width_of(const DensityStep& step) {
  return step.high - step.low;
}

TEST(DensityStep, ADensityThatFallsSlowlyHasAWideRange) {
  std::vector<double> places;
  for (int i = 0; i < 200; ++i)
    places.push_back(-0.3 + 0.6 * std::sqrt((i + 0.5) / 200));  // in proportion to the place
  const DensityStep sharp = density_step(points_about(0.0, 40, 160, -0.3, 0.3, 1), -0.3, 0.3);
  EXPECT_GT(width_of(density_step(places, -0.3, 0.3)), 2 * width_of(sharp));
}

TEST(DensityStep, TheFirstLineOfTheDenserSide) {
  std::vector<double> places;
  for (int line = -6; line <= 6; ++line)
    for (int i = 0; i < (line < 0 ? 2 : 20); ++i) places.push_back(0.05 * line + 0.01);
  const DensityStep step = density_step(places, -0.33, 0.33);
  EXPECT_DOUBLE_EQ(step.at, 0.01);
  EXPECT_LT(width_of(step), 0.05);
}

TEST(DensityStep, NothingIsFoundWithoutPoints) {
  EXPECT_FALSE(density_step({}, -1, 1).found);
  const std::vector<double> at_the_end{-0.99, 0.99};
  EXPECT_FALSE(density_step(at_the_end, -1, 1).found);
}

}  // namespace
}  // namespace ilot
