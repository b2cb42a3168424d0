// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/leaning_side.h"

#include <gtest/gtest.h>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

TEST(LeaningSide, JambsAreDrawnAsTheyLean) {
  const auto left = [](double v) { return 2 + 0.1 * (v - 2); };
  const FacadeSite site = test::scan_wall_open_where(
      [&](double u, double v) { return v > 1 && v < 3 && u > left(v) && u < 3.2 - 0.05 * (v - 2); });
  const RaySamples samples(site);
  const auto openings = find_openings(samples);
  ASSERT_EQ(openings.size(), 1u);
  const FoundRectangle& o = openings[0];
  EXPECT_NEAR(o.lean_of(Side::left), 0.1, 0.01);
  EXPECT_NEAR(o.lean_of(Side::right), -0.05, 0.01);
  EXPECT_EQ(o.lean_of(Side::top), 0);
  EXPECT_EQ(o.lean_of(Side::bottom), 0);
  EXPECT_NEAR(o.at(Side::left), 2, o.error(Side::left));
  EXPECT_NEAR(o.at(Side::right), 3.2, o.error(Side::right));
}

// A head under a slope is a line, not an arc.
TEST(LeaningSide, HeadsUnderASlope) {
  const FacadeSite site = test::scan_wall_open_where(
      [](double u, double v) { return u > 2 && u < 3.4 && v > 1 && v < 2.6 + 0.4 * (u - 2.7); });
  const RaySamples samples(site);
  const auto openings = find_openings(samples);
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_NEAR(openings[0].lean_of(Side::top), 0.4, 0.02);
  EXPECT_NEAR(openings[0].at(Side::top), 2.6, 0.01);
  EXPECT_FALSE(openings[0].arc);
  EXPECT_EQ(openings[0].lean_of(Side::left), 0);
}

TEST(LeaningSide, SquareOpeningsLeanNowhere) {
  const FacadeSite site =
      test::scan_wall_open_where([](double u, double v) { return u > 2 && u < 3.2 && v > 1 && v < 3; });
  const RaySamples samples(site);
  const auto openings = find_openings(samples);
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_FALSE(openings[0].leans());
}

}  // namespace
}  // namespace ilot
