// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/top_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr double kCell = 0.05;

std::vector<double> profile_of(double width, double (*height)(double), double noise = 0) {
  Rng rng(3);
  std::vector<double> profile;
  for (double u = kCell / 2; u < width; u += kCell) profile.push_back(height(u) - noise * rng.uniform());
  return profile;
}

double gable(double u) {
  return u < 2 ? 3 : u < 5 ? 3 + 0.5 * (u - 2) : 4.5 - 0.5 * (u - 5);
}

TEST(TopLines, LevelAndBothSidesOfAGable) {
  const auto lines = top_lines(profile_of(8, gable, 0.02), kCell);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_TRUE(lines[0].level());
  EXPECT_NEAR(lines[0].at, 3, 0.02);
  EXPECT_NEAR(lines[1].slope, 0.5, 0.02);
  EXPECT_NEAR(lines[2].slope, -0.5, 0.02);
  EXPECT_NEAR(lines[1].height(3.5), 3.75, 0.03);
  EXPECT_NEAR(lines[2].height(6.5), 3.75, 0.03);
}

// What hides a fifth of it takes nothing from a line; what stands above it does.
TEST(TopLines, HiddenIsNotContradicted) {
  std::vector<double> profile = profile_of(6, [](double) { return 4.0; });
  for (std::size_t i = 40; i < 64; ++i) profile[i] = 2 + 0.1 * static_cast<double>(i % 7);
  ASSERT_EQ(top_lines(profile, kCell).size(), 1u);
  for (std::size_t i = 40; i < 64; ++i) profile[i] = 6 + 0.3 * static_cast<double>(i % 7);
  EXPECT_EQ(top_lines(profile, kCell).size(), 2u);
}

TEST(TopLines, NothingStraightIsNoLine) {
  Rng rng(5);
  std::vector<double> profile;
  for (int i = 0; i < 100; ++i) profile.push_back(3 + rng.uniform());
  EXPECT_TRUE(top_lines(profile, kCell).empty());
  EXPECT_TRUE(top_lines(std::vector<double>(100, -INFINITY), kCell).empty());
  EXPECT_TRUE(top_lines({}, kCell).empty());
}

TEST(TopLines, ProfileOfRings) {
  const std::vector<OutlineRing> rings{{{0, 0}, {4, 0}, {4, 2}, {2, 4}, {0, 2}}, {{1, 5}, {2, 5}, {2, 6}}};
  const auto top = ring_profile(rings, ProfileOf::columns, 1, 0, 1, 5);
  EXPECT_EQ(top, (std::vector<double>{2.5, 5.5, 3.5, 2.5, -INFINITY}));
  const auto bottom = ring_profile(rings, ProfileOf::columns, -1, 0, 1, 4);
  EXPECT_EQ(bottom, (std::vector<double>{0, 0, 0, 0}));
  const auto left = ring_profile(rings, ProfileOf::rows, -1, 0, 1, 4);
  EXPECT_EQ(left, (std::vector<double>{0, 0, -0.5, -1.5}));
}

}  // namespace
}  // namespace ilot
