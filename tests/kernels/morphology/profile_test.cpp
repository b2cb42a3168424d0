// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/small_images.h"

namespace ilot {
namespace {

TEST(LineProfile, AlongARow) {
  const Image image{5,
                    3,
                    {1, 2, 3, kNoHeight, 5,  //
                     4, 1, 9, kNoHeight, 2,  //
                     7, 8, 9, 9, 9}};
  const LineProfile got = profile_along(image, {0, 1, -0.5}, 0.5);  // rows 0 and 1
  EXPECT_EQ(got.heights, (std::vector<Height>{4, 2, 9, kNoHeight, 5}));
  EXPECT_EQ(got.x, 0);
  EXPECT_EQ(got.y, 0.5);
  EXPECT_EQ(got.dx, 1);
  EXPECT_EQ(got.dy, 0);
}

// Oracle: every pixel's own place along the line.
TEST(LineProfile, ContainsTheHighestPixelOfEachStep) {
  for (const auto& [name, image] : test::small_images()) {
    for (const double degrees : {0.0, 20.0, 45.0, 90.0, 130.0}) {
      const double a = degrees * M_PI / 180;
      ImageLine line{-std::sin(a), std::cos(a), 0};
      line.d = -(line.nx * 6 + line.ny * 5);
      if (line.ny < 1e-12) line = {1, 0, -6};
      const LineProfile got = profile_along(image, line, 2);
      std::vector<Height> want(got.heights.size(), kNoHeight);
      for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x) {
          const Height v = image.values[std::size_t{y} * image.width + x];
          if (v == kNoHeight || std::abs(line.nx * x + line.ny * y + line.d) > 2) continue;
          const double step = (x - got.x) * got.dx + (y - got.y) * got.dy;
          ASSERT_GT(step, -0.501) << name;
          ASSERT_LT(step, static_cast<double>(want.size()) - 0.499) << name;
          Height& entry = want[static_cast<std::size_t>(std::max(0.0, std::floor(step + 0.5 - 1e-9)))];
          entry = std::max(entry, v);
        }
      // Pixels exactly between two steps may fall to either side of them in this oracle: compare where none does.
      if (degrees == 0.0 || degrees == 20.0) {
        ASSERT_EQ(got.heights, want) << name << " " << degrees;
      }
    }
  }
}

TEST(RunningMedian, ClosesShortGapsAndKeepsEdges) {
  const std::vector<Height> profile{5, 5, kNoHeight, 5, 5, 90, 5, 20, 20, 20};
  EXPECT_EQ(running_median(profile, 1), (std::vector<Height>{5, 5, 5, 5, 5, 5, 20, 20, 20, 20}));
  EXPECT_EQ(running_median(profile, 0), profile);
  EXPECT_TRUE(running_median({}, 3).empty());
}

TEST(ProfileCuts, ThreeBlocksByHand) {
  //                               0   1   2   3  4  5  6  7   8   9  10 11 12  13
  const std::vector<Height> profile{12, 15, 11, 14, 0, 0, 0, 0, 13, 12, 1, 2, 16, 16};
  const auto cuts = profile_cuts(profile, 5);
  ASSERT_EQ(cuts.size(), 2u);
  EXPECT_EQ(cuts[0].at, 6u);  // in the middle of the level floor
  EXPECT_EQ(cuts[0].from, 4u);
  EXPECT_EQ(cuts[0].to, 7u);
  EXPECT_EQ(cuts[0].floor, 0);
  EXPECT_EQ(cuts[0].depth, 13);
  EXPECT_EQ(cuts[1].from, 10u);
  EXPECT_EQ(cuts[1].to, 11u);
  EXPECT_EQ(cuts[1].floor, 1);
  EXPECT_EQ(cuts[1].depth, 12);
  EXPECT_EQ(profile_cuts(profile, 2).size(), 3u);  // 11 between 15 and 14 as well
  EXPECT_TRUE(profile_cuts(profile, 20).empty());
}

TEST(ProfileCuts, GapsWithoutPointsAndNothingAtAll) {
  const std::vector<Height> profile{9, 9, kNoHeight, kNoHeight, 9, 9};
  const auto cuts = profile_cuts(profile, 5);
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_EQ(cuts[0].at, 3u);
  EXPECT_EQ(cuts[0].depth, kAboveAll);
  EXPECT_TRUE(profile_cuts({}, 5).empty());
  EXPECT_TRUE(profile_cuts({7}, 5).empty());
  EXPECT_TRUE(profile_cuts({kNoHeight, kNoHeight}, 5).empty());
}

// Oracle: blocks counted from the definition: a top counts when every way to a higher top, or to an equal one before
// it, goes down by more than `depth`.
TEST(ProfileCuts, AsManyAsTopsThatRiseEnough) {
  Rng rng(4);
  for (int round = 0; round < 300; ++round) {
    std::vector<Height> profile;
    for (std::uint64_t i = 0; i < 2 + rng.below(40); ++i) profile.push_back(static_cast<Height>(rng.below(30)));
    for (const Height depth : {0, 3, 8}) {
      std::size_t tops = 0;
      for (std::size_t i = 0; i < profile.size(); ++i) {
        if (i > 0 && profile[i - 1] == profile[i]) continue;  // one entry for each plateau
        bool counts = true;
        for (const int step : {-1, 1}) {
          Height lowest = profile[i];
          for (auto j = static_cast<std::ptrdiff_t>(i) + step; j >= 0 && j < std::ssize(profile); j += step) {
            const Height v = profile[static_cast<std::size_t>(j)];
            lowest = std::min(lowest, v);
            const bool before = v > profile[i] || (v == profile[i] && step < 0);
            if (!before) continue;
            counts &= profile[i] - lowest > depth;
            break;
          }
        }
        tops += counts;
      }
      EXPECT_EQ(profile_cuts(profile, depth).size() + 1, tops) << round << " depth " << depth;
    }
  }
}

}  // namespace
}  // namespace ilot
