// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/sides/edge_bounds.h"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(EdgeBounds, ABlurIsHowFarTheWrongSamplesLie) {
  std::vector<double> inside, outside;
  for (int i = 1; i <= 100; ++i) inside.push_back(-0.001 * i), outside.push_back(0.001 * i);
  EXPECT_EQ(blur_at(inside, outside, 0, 0.05), 0);
  for (int i = 0; i < 10; ++i) inside.push_back(0.02);
  EXPECT_DOUBLE_EQ(blur_at(inside, outside, 0, 0.05), 0.02);
  EXPECT_EQ(blur_at(inside, outside, 0, 0.01), 0);  // they are farther away than that
}

// The wall ends behind a surround at any place of it: the middle of it with half of its width contains them all.
TEST(EdgeBounds, AnEdgeBehindReliefIsWithinIt) {
  constexpr double kWallFrom = 0.1, kInner = -0.02;  // where the wall is seen to begin, and where the surround begins
  Rng rng(3);
  std::vector<double> before;
  for (int i = 0; i < 200; ++i) before.push_back(kInner + (kWallFrom - kInner) * rng.uniform());
  const EdgeSplit split{0.0, 0.1, 0, true};
  const double half = half_of_relief(before, 500, split, kWallFrom);
  EXPECT_NEAR(half, (kWallFrom - kInner) / 2, 0.01);
  for (const double edge : {kInner + 0.01, 0.04, kWallFrom}) EXPECT_NEAR(edge, kWallFrom - half, half + 1e-9);
  EXPECT_EQ(half_of_relief(before, 2000, split, kWallFrom), 0);  // a cable, not a surround
  const std::vector<double> elsewhere{0.3, 0.31, 0.32};
  EXPECT_EQ(half_of_relief(elsewhere, 3, split, kWallFrom), 0);
}

}  // namespace
}  // namespace ilot
