// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/dormers.h"

#include <gtest/gtest.h>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr double kAbove = 10.5, kBehind = 0.4;

// A front of 1.6 by 1.8 m with a window, `left` metres along the wall, seen from the street below.
FacadeSite front_at(double left, const std::vector<test::Sheet>& holes) {
  test::ScannedWall wall;
  wall.width = 1.6, wall.height = 1.8;
  wall.wall(holes);
  FacadeSite site = test::scan_wall(wall, {1 - left, -9, 14}, 0.0008);
  site.axes.origin = {left, kBehind, kAbove};
  return site;
}

DormerFront dormer_at(double left, const std::vector<test::Sheet>& holes) {
  const FacadeSite site = front_at(left, holes);
  return find_dormer(RaySamples(site));
}

Facade bare_wall() {
  Facade facade;
  facade.right = {1, 0, 0}, facade.up = {0, 0, 1}, facade.out = {0, -1, 0};
  facade.width_m = 15, facade.height_m = 10;
  FacadeElement outline;
  outline.id = 1, outline.row = 2, outline.kind = "outline";
  facade.elements = {outline};
  return facade;
}

TEST(Dormers, FrontsWithTheirWindowsOnTheirOwnPlane) {
  const std::vector<test::Sheet> window{{2, -0.15, 0.3, 1.3, 0.4, 1.5}};
  Facade facade = bare_wall();
  EXPECT_GE(add_dormers({dormer_at(2, window), dormer_at(6, window)}, facade), 2u);  // both feet are hidden
  ASSERT_EQ(facade.elements.size(), 5u);
  for (std::size_t i = 0; i < 2; ++i) {
    const double left = i == 0 ? 2 : 6;
    const FacadeElement &front = facade.elements[1 + i], &opening = facade.elements[3 + i];
    EXPECT_EQ(front.kind, "dormer");
    EXPECT_FALSE(front.opening);
    EXPECT_NEAR(front.depth_m, -kBehind, 1e-9);
    EXPECT_EQ(front.edges[0].status, DrawnStatus::occluded);
    EXPECT_EQ(front.edges[2].status, DrawnStatus::seen);
    EXPECT_NEAR(front.ring[0].x, left, 1e-9);
    EXPECT_TRUE(opening.opening);
    EXPECT_EQ(opening.id, 4 + i);
    EXPECT_EQ(opening.row, 3u);
    EXPECT_EQ(opening.column, i + 1);
    EXPECT_EQ(opening.family, 1u);
    EXPECT_NEAR(opening.ring[0].x, left + 0.3, 0.006);
    EXPECT_NEAR(opening.ring[1].x, left + 1.3, 0.006);
    EXPECT_NEAR(opening.ring[2].z, kAbove + 1.5, 0.006);
    EXPECT_NEAR(opening.ring[2].y, kBehind, 1e-9);
    EXPECT_NEAR(opening.depth_m, -0.15, 0.003);
  }
}

// The lower end of the window may be 3 m below, of a window of which a metre was seen.
TEST(Dormers, AnOpeningOfWhichTooLittleWasSeenIsAPossibleOne) {
  DormerFront front = dormer_at(2, {{2, -0.15, 0.3, 1.3, 0.4, 1.5}});
  ASSERT_EQ(front.openings.size(), 1u);
  Facade seen = bare_wall(), facade = bare_wall();
  const std::uint64_t edges = add_dormers({front}, seen);
  LocatedEdge& bottom = front.openings[0].side(Side::bottom);
  bottom.inner = bottom.at, bottom.status = DrawnStatus::occluded, bottom.beyond = 3;
  EXPECT_EQ(add_dormers({front}, facade), edges);
  ASSERT_EQ(facade.elements.size(), 3u);
  const FacadeElement& e = facade.elements[2];
  EXPECT_EQ(e.kind, "possible opening");
  EXPECT_FALSE(e.opening);
  EXPECT_EQ(e.id, 3u);
  EXPECT_EQ(e.row, 0u);
  EXPECT_NEAR(e.ring[0].x, 2.3, 0.006);
  EXPECT_NEAR(e.ring[0].y, kBehind, 1e-9);
  EXPECT_NEAR(e.ring[0].z, kAbove + 0.4, 0.006);
}

TEST(Dormers, WithoutAnOpeningThereIsNone) {
  Facade facade = bare_wall();
  EXPECT_EQ(add_dormers({dormer_at(2, {})}, facade), 0u);
  EXPECT_EQ(facade.elements.size(), 1u);
}

}  // namespace
}  // namespace ilot
