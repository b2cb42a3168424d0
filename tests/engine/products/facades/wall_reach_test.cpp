// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/wall_reach.h"

#include <gtest/gtest.h>

#include "engine/products/facades/wall_sides.h"

namespace ilot {
namespace {

// A wall of 10 by 6 m that looks to -y; on its left it goes on for 3 m and bows back by 3 cm there.
WallGroup wall_with_an_end() {
  WallGroup wall;
  wall.axes = {{100, 50, 2}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  wall.width = 10, wall.height = 6;
  wall.core0 = 1, wall.core1 = 9;
  SparsePart part{-3, 0, 0, 6};
  part.step = 0.3, part.w0 = -0.03;
  wall.sparse = {part};
  return wall;
}

TEST(WallReach, ASparsePartIsAWallOnAPlaneOfItsOwn) {
  const WallGroup wall = wall_with_an_end();
  const WallGroup part = group_of_part(wall, wall.sparse[0], 1);
  EXPECT_NEAR(part.axes.origin.x, 97, 1e-9);
  EXPECT_NEAR(part.axes.origin.y, 50.03, 1e-9) << "three centimetres behind the plane";
  EXPECT_NEAR(part.width, 4.5, 1e-9) << "and one and a half metres of the wall";
  EXPECT_NEAR(part.height, 6, 1e-9);
  const Vec3 end = part.axes.origin + 3 * part.axes.right;
  EXPECT_NEAR(end.y, 50, 1e-4);
  EXPECT_NEAR(norm(cross(part.axes.right, part.axes.up) - part.axes.out), 0, 1e-12);
  EXPECT_NEAR(part.area_m2 / static_cast<double>(part.points), 0.09, 1e-9);
}

TEST(WallReach, TheBoxOfAWallTakesInItsParts) {
  WallGroup wall = wall_with_an_end();
  include_sparse_parts(wall, 1);
  EXPECT_NEAR(wall.axes.origin.x, 97, 1e-9);
  EXPECT_NEAR(wall.width, 13, 1e-9);
  EXPECT_NEAR(wall.core0, 4, 1e-9);
  EXPECT_TRUE(wall.sparse.empty());
}

TEST(WallReach, PartsTurnWithTheirWall) {
  WallGroup wall = wall_with_an_end();
  const Vec3 before = wall.axes.origin - 3.0 * wall.axes.right + wall.sparse[0].w0 * wall.axes.out;
  turn_wall(wall, 1);
  const SparsePart& part = wall.sparse[0];
  EXPECT_EQ(part.u0, 10);
  EXPECT_EQ(part.u1, 13);
  const Vec3 after = wall.axes.origin + part.u1 * wall.axes.right + part.w1 * wall.axes.out;
  EXPECT_NEAR(norm(after - before), 0, 1e-9);
}

}  // namespace
}  // namespace ilot
