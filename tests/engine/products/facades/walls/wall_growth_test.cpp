// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_growth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr double kEpsilonOfWall = 0.02;  // metres
constexpr GrowthRoom kRoom{8, 8, 8};

// Even points on a wall of 6 by 5 metres whose planes end there, and what a test adds to them.
WallGrowth wall_of_six() {
  WallGrowth growth(6, 5, kRoom, kEpsilonOfWall);
  for (double u = 0; u <= 6; u += 0.1)
    for (double v = 0; v <= 5; v += 0.1) growth.add({static_cast<float>(u), static_cast<float>(v), 0, 1});
  return growth;
}

// Points in [u0, u1] x [0, 5], `step` apart; w is drawn from a range.
void add_patch(double u0, double u1, double step, double w0, double w1, WallGrowth& growth) {
  Rng rng(7);
  for (double u = u0 + step / 2; u <= u1; u += step)
    for (double v = step / 2; v <= 5; v += step)
      growth.add({static_cast<float>(u), static_cast<float>(v), static_cast<float>(w0 + (w1 - w0) * rng.uniform()), 0});
}

TEST(WallGrowth, AWallGoesOnWhereItsPointsAreSparse) {
  WallGrowth growth = wall_of_six();
  add_patch(6, 11, 0.4, -0.015, 0.015, growth);
  const std::vector<SparsePart> parts = growth.parts();
  ASSERT_EQ(parts.size(), 2u) << "five metres in parts of four at most";
  EXPECT_EQ(parts[0].u0, 6);
  EXPECT_EQ(parts[0].u1, parts[1].u0);
  EXPECT_NEAR(parts[1].u1, 11, 0.4);
  for (const SparsePart& part : parts) EXPECT_NEAR(part.step, 0.4, 0.1);
}

TEST(WallGrowth, TheSameOnItsLeftAndAboveIt) {
  WallGrowth growth = wall_of_six();
  add_patch(-3, 0, 0.4, -0.015, 0.015, growth);
  for (double u = -3; u <= 6; u += 0.4)
    for (double v = 5; v <= 8; v += 0.4) growth.add({static_cast<float>(u), static_cast<float>(v), 0, 0});
  const std::vector<SparsePart> parts = growth.parts();
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0].u0, -3, 0.4);
  EXPECT_EQ(parts[0].u1, 0);
  EXPECT_EQ(parts[1].v0, 5);
  EXPECT_NEAR(parts[1].v1, 8, 0.4);
  EXPECT_EQ(parts[1].u0, parts[0].u0);
}

TEST(WallGrowth, WhatIsNotOnThePlaneIsNoWall) {
  WallGrowth plant = wall_of_six();
  add_patch(6.2, 10, 0.1, -0.06, 0.06, plant);
  EXPECT_TRUE(plant.parts().empty());
  WallGrowth set_back = wall_of_six();
  add_patch(6.2, 10, 0.1, -0.05, -0.03, set_back);
  EXPECT_TRUE(set_back.parts().empty());
  WallGrowth across = wall_of_six();
  for (double w = -0.06; w <= 0.06; w += 0.005)
    for (double v = 0; v <= 5; v += 0.1) across.add({6.8F, static_cast<float>(v), static_cast<float>(w), 0});
  EXPECT_TRUE(across.parts().empty());
}

TEST(WallGrowth, AGapAsWideAsAWindowIsBridgedAndAnAlleyIsNot) {
  WallGrowth window = wall_of_six();
  add_patch(7.2, 10, 0.3, 0, 0, window);
  EXPECT_FALSE(window.parts().empty());
  WallGrowth alley = wall_of_six();
  add_patch(9, 12, 0.3, 0, 0, alley);
  EXPECT_TRUE(alley.parts().empty());
}

TEST(WallGrowth, AGableIsNoStorey) {
  WallGrowth growth = wall_of_six();
  for (double v = 5; v <= 8; v += 0.1)
    for (double u = v - 5 + 1; u <= 6 - (v - 5) - 1; u += 0.1)
      growth.add({static_cast<float>(u), static_cast<float>(v), 0, 0});
  for (const SparsePart& part : growth.parts()) EXPECT_LT(part.v1, 6.1);
}

WallGroup group_at(double x, double y, double z, double width, double height) {
  WallGroup wall;
  wall.axes = {{x, y, z}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  wall.width = width, wall.height = height;
  return wall;
}

TEST(WallGrowth, ItEndsAtTheNextWall) {
  const std::vector<WallGroup> walls{group_at(0, 0, 0, 6, 5), group_at(9, 0.4, 0, 6, 5), group_at(1, 0.3, 7, 4, 3),
                                     group_at(-6, 5, 0, 4, 5)};
  const std::vector<GrowthRoom> rooms = growth_rooms(walls, 12, {});
  EXPECT_DOUBLE_EQ(rooms[0].right, 3);
  EXPECT_DOUBLE_EQ(rooms[0].top, 2);
  EXPECT_DOUBLE_EQ(rooms[0].left, 12) << "that wall is five metres behind";
  EXPECT_DOUBLE_EQ(rooms[1].left, 3);
}

}  // namespace
}  // namespace ilot
