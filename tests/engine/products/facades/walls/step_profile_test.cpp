// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/step_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// A wall of 20 m x 9 m with 300 points per m2 and 3 mm of noise; w says where its surface is.
StepProfile stepped_wall(const std::function<double(double, double)>& w, std::uint64_t seed) {
  constexpr std::uint64_t kPoints = 54000;
  StepProfile profile(20, 9, kPoints);
  Rng rng(seed);
  for (std::uint64_t i = 0; i < kPoints; ++i) {
    const double u = 20 * rng.uniform(), v = 9 * rng.uniform();
    double noise = -6;
    for (int k = 0; k < 12; ++k) noise += rng.uniform();
    profile.add({static_cast<float>(u), static_cast<float>(v), static_cast<float>(w(u, v) + 0.003 * noise), 1});
  }
  return profile;
}

TEST(StepProfile, StepsOfTwoCentimetresAreFoundWhereTheyAre) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const StepProfile wall = stepped_wall([](double u, double) { return u < 6.3 ? 0 : u < 13.1 ? 0.02 : -0.02; }, seed);
    const std::vector<double> steps = wall.steps({});
    ASSERT_EQ(steps.size(), 2u) << seed;
    EXPECT_NEAR(steps[0], 6.3, 0.03) << seed;
    EXPECT_NEAR(steps[1], 13.1, 0.03) << seed;
    const std::vector<WallStretch> parts = wall.stretches({}, steps, wall);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_NEAR(parts[1].plane.w(10, 4), 0.02, 0.001);
    EXPECT_TRUE(parts[0].right_step && parts[1].left_step && parts[2].left_step);
    EXPECT_FALSE(parts[0].left_step || parts[2].right_step);
    EXPECT_NEAR(parts[0].share, 1, 1e-9);
  }
}

TEST(StepProfile, WallsThatBowLeanOrHaveAPlinthAreOne) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto count = [&](const std::function<double(double, double)>& w) {
      return stepped_wall(w, seed).steps({}).size();
    };
    EXPECT_EQ(count([](double, double) { return 0; }), 0u);
    EXPECT_EQ(count([](double u, double v) { return 0.03 * std::sin(u / 20 * M_PI) + 0.003 * v; }), 0u);
    EXPECT_EQ(count([](double u, double v) { return u > 10 && v < 3 ? 0.03 : 0; }), 0u) << "a plinth";
    EXPECT_EQ(count([](double u, double) { return u > 10 && u < 10.9 ? 0.03 : 0; }), 0u) << "a pilaster";
    EXPECT_EQ(count([](double u, double) { return u > 10 ? 0.005 : 0; }), 0u) << "half a centimetre";
  }
}

TEST(StepProfile, AGapOfThreeMetresPartsAWall) {
  StepProfile profile(20, 9, 20000);
  for (int i = 0; i < 20000; ++i) {
    const double u = 20 * (i % 200) / 200.0, v = 9 * (i / 200) / 100.0;
    if (u < 5 || u > 9) profile.add({static_cast<float>(u), static_cast<float>(v), 0, 1});
  }
  const std::vector<WallStretch> parts = profile.stretches({}, {}, profile);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_LT(parts[0].u1, 5);
  EXPECT_GT(parts[1].u0, 9);
}

}  // namespace
}  // namespace ilot
