// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/wall_sides.h"

#include <gtest/gtest.h>

#include <array>

namespace ilot {
namespace {

// A wall that looks to -y with its left foot at (x, y, z).
WallGroup wall_at(double x, double y, double z, double width, double height) {
  WallGroup wall;
  wall.axes = {{x, y, z}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  wall.width = width;
  wall.height = height;
  wall.area_m2 = width * height;
  return wall;
}

TEST(WallSides, AStoreyThatStandsBackLooksWhereTheLargerOneAboveItLooks) {
  const WallGroup upper = wall_at(0, 0, 2, 10, 6);
  WallGroup lower = wall_at(0, 2, 0, 10, 2);
  const std::array<double, 2> own{3, -3};
  const std::array walls{upper, lower};
  EXPECT_EQ(storey_odds(walls, own, 1, 1), 3);
  EXPECT_EQ(storey_odds(walls, own, 0, 1), 3);  // the larger one does not ask the smaller one
  turn_wall(lower, 1);
  EXPECT_EQ(storey_odds(std::array{upper, lower}, own, 1, 1), -3);  // odds are for the wall's own side
}

TEST(WallSides, WallsFarOffBesideOrUnsureDecideNothing) {
  const std::array<double, 2> own{3, -2}, unsure{0.5, -2};
  const WallGroup lower = wall_at(0, 0, 0, 10, 2);
  const auto odds = [&](const WallGroup& other, const std::array<double, 2>& of) {
    return storey_odds(std::array{other, lower}, of, 1, 1);
  };
  EXPECT_EQ(odds(wall_at(0, 1, 2, 10, 6), own), 3);
  EXPECT_EQ(odds(wall_at(0, 4, 2, 10, 6), own), -2);  // another house
  EXPECT_EQ(odds(wall_at(8, 1, 2, 10, 6), own), -2);  // above a fifth of it
  EXPECT_EQ(odds(wall_at(0, 1, 0, 10, 6), own), -2);  // beside, not above
  EXPECT_EQ(odds(wall_at(0, 1, 2, 10, 6), unsure), -2);
}

TEST(WallSides, HousesOfOnePlaneFaceOneStreet) {
  std::array walls{wall_at(0, 0, 0, 10, 6), wall_at(10, 0.1, 0, 10, 6)};
  walls[0].segments = {1}, walls[1].segments = {1};
  std::array<Segment, 1> plane;
  plane[0].plane.n = {0, -1, 0};
  EXPECT_NEAR(segment_side_odds(walls, std::array<double, 2>{5, -3}, plane)[1], 2, 1e-12);
  EXPECT_NEAR(segment_side_odds(walls, std::array<double, 2>{-3, 5}, plane)[1], 2, 1e-12);
  turn_wall(walls[1], 1);
  EXPECT_NEAR(segment_side_odds(walls, std::array<double, 2>{5, 3}, plane)[1], 2, 1e-12);
}

}  // namespace
}  // namespace ilot
