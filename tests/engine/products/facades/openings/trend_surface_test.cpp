// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/trend_surface.h"

#include <gtest/gtest.h>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

// A wall of which plates 1.3 m wide and 2 m high take more than half, each `out` before it.
FacadeSite covered_wall(double out) {
  test::ScannedWall wall;
  wall.width = 7.6, wall.height = 7;
  wall.wall({});
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 5; ++column) {
      const double u = 0.2 + 1.5 * column, v = 0.3 + 2.3 * row;
      wall.block(u, u + 1.3, v, v + 2, out, 2);
    }
  return test::scan_wall(wall, {3.8, 1.4, 9}, 0.004, 999, 0.003);
}

TEST(TrendSurface, LeavesThatCoverMostOfAWallAreNotItsForm) {
  const FacadeSite site = covered_wall(0.04);
  const TrendSurface form = trend_surface(RaySamples(site));
  ASSERT_TRUE(form.found);
  for (const double u : {0.1, 3.8, 7.5})
    for (const double v : {0.1, 3.5, 6.9}) EXPECT_NEAR(form.at(u, v), 0, 0.006) << u << " " << v;
  EXPECT_LT(form.noise, 0.006);
}

// A shop front 5 cm behind a wall goes on as far as the wall does, but is less of it.
TEST(TrendSurface, ALongRecessIsNotTheFormOfAWall) {
  test::ScannedWall wall;
  wall.wall({{2, -0.05, 0.5, 5.5, 0.2, 1.8}});
  const FacadeSite site = test::scan_wall(wall, {3, 1.4, 8}, 0.004, 999, 0.003);
  const TrendSurface form = trend_surface(RaySamples(site));
  ASSERT_TRUE(form.found);
  EXPECT_NEAR(form.at(3, 3), 0, 0.006);
}

// The wall of a house that stands 3 cm farther out, beside that of a lower part, is no set of leaves.
TEST(TrendSurface, AHouseThatStandsFartherOutIsNoLeaf) {
  test::ScannedWall wall;
  wall.width = 10;
  wall.wall({});
  wall.block(4, 10, 0, 4, 0.03, 1);
  const FacadeSite site = test::scan_wall(wall, {5, 1.4, 9}, 0.004, 999, 0.002);
  const TrendSurface form = trend_surface(RaySamples(site));
  ASSERT_TRUE(form.found);
  EXPECT_GT(form.at(7, 2), 0.02);
}

// Two houses on one sheet. Of the one that stands farther out the points are so sparse that no run of cells is long.
TEST(TrendSurface, ASparseHouseThatStandsFartherOutIsNoLeaf) {
  test::ScannedWall wall;
  wall.width = 10;
  wall.wall({});
  wall.block(4, 10, 0, 4, 0.06, 1);
  FacadeSite site = test::scan_wall(wall, {5, 1.4, 9}, 0.004, 999, 0.002);
  std::size_t seen = 0;
  std::erase_if(site.points, [&](const FacadePoint& p) { return p.u > 4 && ++seen % 10 != 0; });
  std::erase_if(site.points, [&](const FacadePoint& p) { return p.u < 4 && p.v > 0.5; });
  const TrendSurface form = trend_surface(RaySamples(site));
  ASSERT_TRUE(form.found);
  EXPECT_GT(form.at(7, 2), 0.04);
}

// Stones 3 cm before the joints between them, which go on over the whole wall.
TEST(TrendSurface, JointsAreNotTheFormOfAWallOfStones) {
  test::ScannedWall wall;
  wall.width = 6, wall.height = 4;
  wall.wall({});
  for (double v = 0.03; v < 4; v += 0.4)
    for (double u = 0.03; u < 6; u += 0.6) wall.block(u, u + 0.54, v, v + 0.34, 0.03, 1);
  const FacadeSite site = test::scan_wall(wall, {3, 2, 8}, 0.002, 999, 0.002);
  const TrendSurface form = trend_surface(RaySamples(site));
  ASSERT_TRUE(form.found);
  EXPECT_NEAR(form.at(3, 2), 0.03, 0.006);
}

}  // namespace
}  // namespace ilot
