// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/level_tops.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr double kLevelStep = 0.3;

// A slope with a plane of its own, points every 0.3 m but where a box hides it, and what is put on it.
struct Roof {
  RoofSite site;
  RoofPlanes planes;

  Roof() {
    planes.step = kLevelStep;
    planes.epsilon = 0.08;
    planes.planes.push_back({0, 2, 0, 0, 12, 0});
    for (double x = 0; x < 6; x += kLevelStep)
      for (double y = 0; y < 6; y += kLevelStep)
        if (x < 2 || x > 3.4 || y < 2 || y > 2.7) add({x, y, 2 * y}, 1);
  }
  void add(Vec3 p, std::uint32_t plane) {
    site.points.push_back(p);
    planes.of_point.push_back(plane);
    planes.on_wall.push_back(0);
    if (plane != 0) ++planes.planes[plane - 1].points;
  }
};

void add_top(Roof& roof) {
  for (const double x : {2.1, 2.4, 2.7, 3.0})
    for (const double y : {2.1, 2.4}) roof.add({x, y, 5.5 + 0.05 * (x - 2.5)}, 0);
}

TEST(LevelTops, ABoxOnASlopeIsAPlane) {
  Roof roof;
  add_top(roof);
  add_level_tops(roof.site, roof.planes);
  ASSERT_EQ(roof.planes.planes.size(), 2u);
  EXPECT_NEAR(roof.planes.planes[1].c, 5.5, 0.01);
  EXPECT_EQ(roof.planes.planes[1].gx, 0);
  EXPECT_EQ(roof.planes.planes[1].points, 8u);
  EXPECT_EQ(std::count(roof.planes.of_point.begin(), roof.planes.of_point.end(), 2u), 8);
}

TEST(LevelTops, WhatTheRoofIsSeenThroughIsNoSurface) {
  Roof roof;
  add_top(roof);
  for (const double x : {2.25, 2.55, 2.85}) roof.add({x, 2.25, 4.5}, 1);
  add_level_tops(roof.site, roof.planes);
  EXPECT_EQ(roof.planes.planes.size(), 1u);
}

TEST(LevelTops, HitsOnAWallAreNoSurface) {
  Roof roof;
  for (double x = 2; x < 3.4; x += 0.2) roof.add({x, 2.3, 5.5}, 0);
  add_level_tops(roof.site, roof.planes);
  EXPECT_EQ(roof.planes.planes.size(), 1u);
}

TEST(LevelTops, TwoBoxesTakenForOnePlaneComeApart) {
  Roof roof;
  std::erase_if(roof.site.points, [](Vec3 p) { return p.x > 4.2 && p.x < 5.6 && p.y > 2 && p.y < 2.7; });
  roof.planes.of_point.assign(roof.site.points.size(), 1);
  roof.planes.on_wall.assign(roof.site.points.size(), 0);
  roof.planes.planes.push_back({0, 0, 5.5, 5.5, 5.5, 0});
  for (const double x : {2.1, 2.4, 2.7, 4.5, 4.8, 5.1})
    for (const double y : {2.1, 2.4}) roof.add({x, y, 5.5}, 2);
  for (const double x : {3.45, 3.6, 3.75, 3.9}) roof.add({x, 2.25, 4.5}, 1);
  add_level_tops(roof.site, roof.planes);
  ASSERT_EQ(roof.planes.planes.size(), 3u) << "the slope and two tops";
  for (const std::uint32_t plane : {2u, 3u})
    EXPECT_EQ(std::count(roof.planes.of_point.begin(), roof.planes.of_point.end(), plane), 6);
}

TEST(LevelTops, ASmallSlopeIsNotCutIntoSteps) {
  Roof roof;
  roof.planes.planes.push_back({0, 0.8, 3, 0, 12, 0});
  for (const double x : {2.1, 2.4, 2.7, 3.0})
    for (const double y : {2.05, 2.15, 2.25, 2.35, 2.45, 2.55}) roof.add({x, y, 3 + 0.8 * y}, 2);
  add_level_tops(roof.site, roof.planes);
  EXPECT_EQ(roof.planes.planes.size(), 2u);
}

}  // namespace
}  // namespace ilot
