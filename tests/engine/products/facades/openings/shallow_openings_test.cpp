// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/shallow_openings.h"

#include <gtest/gtest.h>

#include "engine/products/facades/openings/trend_surface.h"
#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr Vec3 kShallowEye{1, 1.5, 8};
constexpr double kShallowStep = 0.003, kShallowNoise = 0.005;  // tangent; metres

// A scan of a wall with one hole, bowed by 2 cm in its middle.
FacadeSite bowed(const test::Sheet& hole) {
  test::ScannedWall wall;
  wall.wall({hole});
  FacadeSite site = test::scan_wall(wall, kShallowEye, kShallowStep, 999, kShallowNoise);
  for (FacadePoint& p : site.points) {
    const double x = p.u / site.width - 0.5;
    p.w += static_cast<float>(0.02 - 0.08 * x * x);
    p.plane = 0;  // nothing but the points says what the wall is
  }
  site.wall.clear();
  return site;
}

TEST(TrendSurface, AWallThatBowsIsLevelAboutItsForm) {
  const FacadeSite site = bowed({2, -0.03, 2, 3.1, 1.2, 2.8, 0});
  const TrendSurface form = trend_surface(RaySamples(site));
  ASSERT_TRUE(form.found);
  for (const double u : {0.3, 1.5, 3.0, 4.5, 5.7}) {
    const double x = u / site.width - 0.5;
    EXPECT_NEAR(form.at(u, 2), 0.02 - 0.08 * x * x, 0.002);
  }
  EXPECT_NEAR(form.noise, 2 * kShallowNoise / 2, 0.002);  // the sum of three uniform numbers deviates by a half
}

TEST(ShallowOpenings, APaneThreeCentimetresBehindABowedWall) {
  const FacadeSite site = bowed({2, -0.03, 2, 3.1, 1.2, 2.8, 0});
  const RaySamples samples(site);
  const std::vector<FoundRectangle> found = find_openings(samples);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at(Side::left), 2, found[0].error(Side::left));
  EXPECT_NEAR(found[0].at(Side::right), 3.1, found[0].error(Side::right));
  EXPECT_NEAR(found[0].at(Side::bottom), 1.2, found[0].error(Side::bottom));
  EXPECT_NEAR(found[0].at(Side::top), 2.8, found[0].error(Side::top));
  EXPECT_NEAR(found[0].depth, -0.03, 0.01);
  for (const Side side : kSides) EXPECT_LT(found[0].error(side), 0.06);
}

// A pipe in the middle of a pane hides it from top to bottom.
TEST(ShallowOpenings, APipeDividesNoPane) {
  test::ScannedWall wall;
  wall.wall({{2, -0.03, 2, 3.1, 1.2, 2.8, 0}});
  wall.sheets.push_back({2, 0.12, 2.5, 2.58, 0.1, 3.9, 7});
  FacadeSite site = test::scan_wall(wall, kShallowEye, kShallowStep, 999, kShallowNoise);
  for (FacadePoint& p : site.points) p.plane = 0;
  site.wall.clear();
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at(Side::left), 2, found[0].error(Side::left));
  EXPECT_NEAR(found[0].at(Side::right), 3.1, found[0].error(Side::right));
}

// A panel before the wall hides a part of the pier between two panes: each is an opening of its own.
TEST(ShallowOpenings, AHiddenPierDividesTwoPanes) {
  test::ScannedWall wall;
  wall.wall({{2, -0.03, 1, 2.2, 1.2, 2.8, 0}, {2, -0.03, 2.6, 3.8, 1.2, 2.8, 0}});
  wall.sheets.push_back({2, 0.2, 2.25, 2.55, 1.3, 2, 7});
  FacadeSite site = test::scan_wall(wall, {2.4, 1.5, 8}, kShallowStep, 999, kShallowNoise);
  for (FacadePoint& p : site.points) p.plane = 0;
  site.wall.clear();
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(found[0].at(Side::right), 2.6);
  EXPECT_GT(found[1].at(Side::left), 2.2);
}

// A pane at twice the scatter of the wall, and at one and a third of it: the means of points over some cells show what
// single points do not.
TEST(ShallowOpenings, APaneThatIsHardlyDeeperThanTheScatter) {
  for (const double scatter : {0.013, 0.022}) {
    SCOPED_TRACE(scatter);
    test::ScannedWall wall;
    wall.wall({{2, -0.03, 2, 3.1, 1.2, 2.8, 0}});
    FacadeSite site = test::scan_wall(wall, kShallowEye, kShallowStep, 999, scatter);
    for (FacadePoint& p : site.points) p.plane = 0;
    site.wall.clear();
    const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
    ASSERT_EQ(found.size(), 1u);
    for (const auto& [side, at] :
         {std::pair{Side::left, 2.0}, {Side::right, 3.1}, {Side::bottom, 1.2}, {Side::top, 2.8}})
      EXPECT_NEAR(found[0].at(side), at, found[0].error(side));
  }
}

// Where the wall goes back beside a pane as far as the least step, a larger step parts them.
TEST(ShallowOpenings, APaneInAWallThatGoesBackBesideIt) {
  test::ScannedWall wall;
  wall.wall({{2, -0.05, 2, 3.1, 1.2, 2.8, 0}});
  FacadeSite site = test::scan_wall(wall, kShallowEye, kShallowStep, 999, 0.004);
  for (FacadePoint& p : site.points) {
    p.plane = 0;
    if (p.u > 2.5F) p.w -= 0.02F * std::min(1.0F, (p.u - 2.5F) / 0.3F);
  }
  site.wall.clear();
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_GE(found.size(), 1u);
  EXPECT_NEAR(found[0].at(Side::left), 2, found[0].error(Side::left));
  EXPECT_NEAR(found[0].at(Side::right), 3.1, found[0].error(Side::right));
}

// Some twenty points on a pane show it, and the pane beside it, past a narrow pier, is no wall about it.
TEST(ShallowOpenings, TwoPanesOfFewPointsWithANarrowPier) {
  test::ScannedWall wall;
  wall.wall({{2, -0.05, 1.7, 2.7, 1.4, 2.2, 0}, {2, -0.05, 3.0, 4.0, 1.4, 2.2, 0}});
  FacadeSite site = test::scan_wall(wall, {2.8, 1.5, 8}, 0.02, 999, 0.006);
  for (FacadePoint& p : site.points) p.plane = 0;
  site.wall.clear();
  const std::vector<FoundRectangle> found = find_openings(RaySamples(site));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].at(Side::left), 1.7, found[0].error(Side::left));
  EXPECT_NEAR(found[1].at(Side::right), 4.0, found[1].error(Side::right));
  EXPECT_LT(found[0].at(Side::right), 3.0);
  EXPECT_GT(found[1].at(Side::left), 2.7);
}

TEST(ShallowOpenings, WhatLiesWithinTheNoiseOrIsAJointIsNone) {
  EXPECT_TRUE(find_openings(RaySamples(bowed({2, -0.01, 2, 3.1, 1.2, 2.8, 0}))).empty());
  EXPECT_TRUE(find_openings(RaySamples(bowed({2, -0.03, 0.5, 5.5, 2, 2.1, 0}))).empty());
}

TEST(ShallowOpenings, PiecesGiveWayToTheWholeAndWholesStay) {
  const auto rectangle = [](const Box2& b) {
    FoundRectangle r;
    r.side(Side::left).at = b.u0, r.side(Side::right).at = b.u1, r.side(Side::bottom).at = b.v0,
    r.side(Side::top).at = b.v1;
    return r;
  };
  std::vector<FoundRectangle> found{rectangle({1, 2, 1, 1.4}), rectangle({4, 6, 1, 3})};
  add_shallow_openings({rectangle({1, 2, 1, 2.4}), rectangle({4.1, 5.5, 1, 3})}, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_DOUBLE_EQ(found[0].at(Side::right), 6);
  EXPECT_DOUBLE_EQ(found[1].at(Side::top), 2.4);
}

}  // namespace
}  // namespace ilot
