// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/step_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(StepOffset, LiesBesideTheUpperPoints) {
  const std::vector<StepGap> gaps{{1.0, 2.0}, {0.9, 1.8}, {0.7, 3.0}};
  EXPECT_DOUBLE_EQ(step_offset(gaps, 0.1), 1.1) << "the shadow of the upper roof reaches to 1.8";
  EXPECT_DOUBLE_EQ(step_offset(gaps, 5), 1.4) << "at most halfway";
}

TEST(StepOffset, UpperPointsMayBeOnEitherSide) {
  EXPECT_DOUBLE_EQ(step_offset(std::vector<StepGap>{{2.0, 1.0}, {2.1, 0.5}}, 0.1), 1.9);
}

TEST(StepOffset, AFewWrongPairsDoNotMoveIt) {
  const std::vector<StepGap> gaps{{1.0, 1.2}, {0.9, 1.3}, {1.1, 1.4}, {0.2, 0.4}, {2.0, 2.5}};
  EXPECT_DOUBLE_EQ(step_offset(gaps, 0), 1.1);
}

TEST(StepOffset, NoPairsNoPlace) {
  EXPECT_DOUBLE_EQ(step_offset({}, 1), 0);
}

TEST(StepOffset, NoOtherOffsetPartsMorePairs) {
  Rng rng(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<StepGap> gaps(1 + rng.below(12));
    for (StepGap& g : gaps) g = {static_cast<double>(rng.below(20)), static_cast<double>(rng.below(20))};
    const auto separated = [&](double offset) {
      return std::count_if(gaps.begin(), gaps.end(), [&](const StepGap& g) {
        return std::min(g.upper, g.lower) <= offset && offset <= std::max(g.upper, g.lower);
      });
    };
    const auto most = separated(step_offset(gaps, 0.25));
    for (double offset = 0; offset < 20; offset += 0.5) EXPECT_LE(separated(offset), most) << offset;
  }
}

}  // namespace
}  // namespace ilot
