// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/agreement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(Agreement, WhatAllBoundsHold) {
  const std::vector<Bounded> measured{{1.00, 0.05}, {1.04, 0.05}, {0.97, 0.05}};
  const Bounded common = agreement(measured);
  EXPECT_NEAR(common.value, 1.005, 1e-12);  // 0.99 to 1.02
  EXPECT_NEAR(common.error, 0.015, 1e-12);
  EXPECT_EQ(agreement({}).error, 0);
}

TEST(Agreement, TheOddOneOutIsLeftOut) {
  const std::vector<Bounded> measured{{5, 0.1}, {1.00, 0.05}, {1.02, 0.05}};
  EXPECT_NEAR(agreement(measured).value, 1.01, 1e-12);
}

// Edges that fall anywhere within a step: many of them tell the truth much better than one.
TEST(Agreement, ManyNarrowDown) {
  Rng rng(5);
  double worst = 0;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Bounded> measured;
    for (int i = 0; i < 15; ++i) measured.push_back({2 + 0.02 * (rng.uniform() - 0.5), 0.01});
    const Bounded common = agreement(measured);
    EXPECT_LE(std::abs(common.value - 2), common.error + 1e-12);
    worst = std::max(worst, common.error);
    std::reverse(measured.begin(), measured.end());
    EXPECT_EQ(agreement(measured).value, common.value);
  }
  EXPECT_LT(worst, 0.006);
}

TEST(GroupsOfEquals, ByValueWithinTheTolerance) {
  const std::vector<double> values{3.0, 1.0, 1.04, 3.02, 2.0, 1.06};
  EXPECT_EQ(groups_of_equals(values, 0.05), (std::vector<std::size_t>{3, 0, 0, 3, 2, 1}));
}

}  // namespace
}  // namespace ilot
