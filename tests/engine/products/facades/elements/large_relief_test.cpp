// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/large_relief.h"

#include <gtest/gtest.h>

#include "tests/support/sampled_site.h"

namespace ilot {
namespace {

using test::SampledSite;

// A bay of splayed sides: 4 m wide at the wall, 2 m at its front, 1 m out.
SampledSite with_bay(double noise) {
  SampledSite s(6, 4, 0.03, noise);
  s.wall_around(1, 5, 1, 3);
  s.sheet(2, 4, 1, 3, 1, 2);
  s.face({1, 1, 0}, {1, 0, 1}, {0, 2, 0}, 3);
  s.face({4, 1, 1}, {1, 0, -1}, {0, 2, 0}, 4);
  for (const double v : {1.0, 3.0}) s.face({1, v, 0}, {4, 0, 0}, {0, 0, 0.5}, 5);
  return s;
}

TEST(LargeRelief, ABayWithSplayedSidesIsMeasuredAtTheWallAndAtItsFront) {
  for (const double noise : {0.0005, 0.005}) {
    const SampledSite s = with_bay(noise);
    const RaySamples samples(s.site);
    const auto found = find_large_relief(samples);
    ASSERT_EQ(found.size(), 1u) << noise;
    const Box2 box = found[0].box();
    EXPECT_NEAR(box.u0, 1, 0.01) << noise;
    EXPECT_NEAR(box.u1, 5, 0.01) << noise;
    EXPECT_NEAR(found[0].depth, 1, 0.005) << noise;
    ASSERT_TRUE(found[0].end);
    EXPECT_NEAR(found[0].end->u0, 2, 0.01) << noise;
    EXPECT_NEAR(found[0].end->u1, 4, 0.01) << noise;
  }
}

// The tower at a corner, under a roof that slopes back to above the wall's top.
TEST(LargeRelief, APartMayGoBeyondTheEndsOfItsWall) {
  for (const double noise : {0.0005, 0.005}) {
    SampledSite s(6, 4, 0.03, noise);
    s.wall_around(4, 6, 1, 4);
    s.sheet(4, 7.5, 1, 4, 1, 2);
    for (const double u : {4.0, 7.5}) s.face({u, 1, 0}, {0, 0, 1}, {0, 3, 0}, 3);
    s.face({4, 1, 0}, {3.5, 0, 0}, {0, 0, 1}, 4);
    s.face({4, 4, 1}, {3.5, 0, 0}, {0, 1.5, -1}, 5);
    const auto found = find_large_relief(RaySamples(s.site));
    ASSERT_EQ(found.size(), 1u) << noise;
    const Box2 box = found[0].box();
    EXPECT_NEAR(box.u0, 4, 0.01) << noise;
    EXPECT_NEAR(box.u1, 7.5, 0.01) << noise;
    EXPECT_NEAR(box.v0, 1, 0.01) << noise;
    EXPECT_NEAR(box.v1, 5.5, 0.02) << noise << " where the roof comes to the wall's plane";
    ASSERT_TRUE(found[0].end);
    EXPECT_NEAR(found[0].end->v1, 4, 0.02) << noise << " where it begins at the front";
  }
}

// A fifth of it stands on consoles: where they end it does not.
TEST(LargeRelief, ConsolesBelowABalconyAreNotItsFoot) {
  SampledSite s(6, 4, 0.03, 0.002);
  s.wall_around(0, 6, 2, 3);
  s.sheet(0, 6, 2, 3, 0.8, 2);
  s.face({0, 2, 0}, {6, 0, 0}, {0, 0, 0.8}, 3);
  for (const double u : {0.8, 2.8, 4.8}) {
    s.sheet(u, u + 0.4, 1.5, 2, 0.6, 4);
    for (const double side : {u, u + 0.4}) s.face({side, 1.5, 0}, {0, 0, 0.6}, {0, 0.5, 0}, 5);
  }
  const auto found = find_large_relief(RaySamples(s.site));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].box().v0, 2, 0.01);
  EXPECT_NEAR(found[0].box().v1, 3, 0.05);
  EXPECT_NEAR(found[0].depth, 0.8, 0.005);
}

// What was not seen to end is the storey above, a wall of its own.
TEST(LargeRelief, WhatGoesOnBeyondWhatWasLookedAtIsNoPartOfTheWall) {
  for (const double height : {4.5, 9.0}) {
    SampledSite s(6, 3, 0.03, 0.002);
    s.sheet(0, 6, 0, 3, 0, 1);
    s.sheet(0, 6, 3, height, 1, 2);
    s.face({0, 3, 0}, {6, 0, 0}, {0, 0, 1}, 3);
    EXPECT_EQ(find_large_relief(RaySamples(s.site)).size(), height < 5.5 ? 1u : 0u) << height;
  }
}

TEST(LargeRelief, ANicheGoesIntoTheWall) {
  SampledSite s(6, 4, 0.03, 0.002);
  s.wall_around(2, 3.5, 0, 2.4);
  s.sheet(2, 3.5, 0, 2.4, -0.9, 2);
  for (const double u : {2.0, 3.5}) s.face({u, 0, -0.9}, {0, 0, 0.9}, {0, 2.4, 0}, 3);
  s.face({2, 2.4, -0.9}, {1.5, 0, 0}, {0, 0, 0.9}, 4);
  const auto found = find_large_relief(RaySamples(s.site));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, -0.9, 0.005);
  EXPECT_NEAR(found[0].box().u0, 2, 0.01);
  EXPECT_NEAR(found[0].box().u1, 3.5, 0.01);
  EXPECT_NEAR(found[0].box().v1, 2.4, 0.01);
}

// Foremost, but not built on: no side faces lead from the wall to it.
TEST(LargeRelief, WhatStandsBeforeTheWallIsNoPartOfIt) {
  SampledSite s(6, 4, 0.03, 0.002);
  s.sheet(0, 6, 0, 4, 0, 1);
  s.sheet(2, 4, 0, 1.5, 1.4, 2);
  for (const double u : {2.0, 4.0}) s.face({u, 0, 1.4}, {0, 0, 0.9}, {0, 1.5, 0}, 3);
  EXPECT_TRUE(find_large_relief(RaySamples(s.site)).empty());
}

// Beyond its end the wall does not go on: what is seen there is another part of the house.
TEST(LargeRelief, NothingBeyondTheEndIsARecess) {
  SampledSite s(6, 4, 0.03, 0.002);
  s.sheet(0, 4.5, 0, 4, 0, 1);
  s.sheet(4.5, 6, 0, 4, -1, 2);
  EXPECT_TRUE(find_large_relief(RaySamples(s.site)).empty());
}

}  // namespace
}  // namespace ilot
