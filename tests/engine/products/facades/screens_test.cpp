// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/screens.h"

#include <gtest/gtest.h>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

constexpr Vec3 kScreenEye{2, 1.6, 8};

// Planks 20 cm high, one each 2 m, and posts of 10 cm, one each 1.5 m, before a wall with two windows.
FacadeSite scaffold_at(double behind) {
  test::ScannedWall front;
  for (double v = 0; v < front.height; v += 2) front.sheets.push_back({2, 0, 0, front.width, v, v + 0.2, 1});
  for (double u = 0; u < front.width; u += 1.5) front.sheets.push_back({2, 0, u, u + 0.1, 0, front.height, 1});
  test::ScannedWall wall;
  wall.wall({{2, -0.2, 1, 2, 1, 2.5, 0}, {2, -0.2, 3, 4, 1, 2.5, 0}});
  for (test::Sheet s : wall.sheets) {
    if (s.axis == 2) s.at -= behind;
    s.plane = 2;
    front.sheets.push_back(s);
  }
  return test::scan_wall(front, kScreenEye, 0.005);
}

TEST(Screens, AScaffoldIsNoWall) {
  const FacadeSite site = scaffold_at(1);
  EXPECT_TRUE(is_screen(RaySamples(site), 1));
  EXPECT_FALSE(is_screen(RaySamples(site), 1.6));  // no wall there
}

TEST(Screens, AWallWithWindowsIsNone) {
  test::ScannedWall wall;
  wall.wall({{2, -1, 0.5, 2.5, 0.5, 3.5, 0}, {2, -1, 3.5, 5.5, 0.5, 3.5, 0}});
  const FacadeSite site = test::scan_wall(wall, kScreenEye, 0.005);
  EXPECT_FALSE(is_screen(RaySamples(site), 0.5));
}

WallGroup group_at(double u, double behind, double width, Vec3 out = {0, -1, 0}) {
  WallGroup wall;
  wall.axes.right = {-out.y, out.x, 0}, wall.axes.up = {0, 0, 1}, wall.axes.out = out;
  wall.axes.origin = {u, behind, 0};
  wall.width = width, wall.height = 6;
  return wall;
}

TEST(Screens, TheWallBehindStandsNearAndAlongMostOfIt) {
  const WallGroup front = group_at(0, 0, 10);
  EXPECT_DOUBLE_EQ(depth_behind(front, group_at(2, 1, 12), 1), 1);
  EXPECT_DOUBLE_EQ(depth_behind(front, group_at(2, 1 / 0.3048, 12 / 0.3048), 0.3048), 1);
  EXPECT_EQ(depth_behind(front, group_at(6, 1, 12), 1), 0);              // beside it
  EXPECT_EQ(depth_behind(front, group_at(2, 0.2, 12), 1), 0);            // in its plane
  EXPECT_EQ(depth_behind(front, group_at(2, 3, 12), 1), 0);              // another house
  EXPECT_EQ(depth_behind(front, group_at(2, -1, 12), 1), 0);             // before it
  EXPECT_EQ(depth_behind(front, group_at(10, 1, 10, {0, 1, 0}), 1), 0);  // faces the other way
}

}  // namespace
}  // namespace ilot
