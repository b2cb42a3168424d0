// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/trees/trunks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/products/streets/trees/circle_fit.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(CircleFit, PointsOfAnArcGiveTheirCircle) {
  for (const double half_deg : {30.0, 60.0, 180.0}) {
    std::vector<CirclePoint> points;
    for (int i = 0; i <= 40; ++i) {
      const double a = (half_deg * (i - 20) / 20) * 3.14159265358979 / 180;
      points.push_back({7 + 0.25 * std::cos(a), -3 + 0.25 * std::sin(a)});
    }
    const Circle circle = fit_circle(points);
    EXPECT_NEAR(circle.x, 7, 1e-6) << half_deg;
    EXPECT_NEAR(circle.y, -3, 1e-6) << half_deg;
    EXPECT_NEAR(circle.radius, 0.25, 1e-6) << half_deg;
  }
}

TEST(CircleFit, NoneForPointsOnALineAndForFew) {
  std::vector<CirclePoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({0.1 * i, 0.2 * i});
  EXPECT_EQ(fit_circle(points).radius, 0);
  EXPECT_EQ(fit_circle(std::span(points).first(3)).radius, 0);
}

TrunkVoxels trunk_voxels(const std::vector<std::array<double, 3>>& points) {
  TrunkVoxels v;
  v.width = v.height = 80;
  v.slices = 12;
  for (const auto& [x, y, h] : points) {
    const double s = (h - v.first) / v.slice;
    if (s < 0 || s >= v.slices) continue;
    const auto a = static_cast<std::uint32_t>(x / v.side), b = static_cast<std::uint32_t>(y / v.side);
    TrunkVoxel& voxel = v.add(static_cast<std::uint32_t>(s), a, b);
    voxel.x += static_cast<std::uint32_t>((x - a * v.side) / v.side * kTrunkSteps);
    voxel.y += static_cast<std::uint32_t>((y - b * v.side) / v.side * kTrunkSteps);
    ++voxel.points;
  }
  return v;
}

// The side of an upright cylinder that is seen from the south, from 0 to 4 m.
void add_trunk_side(double x, double y, double radius, double lean, std::vector<std::array<double, 3>>& points) {
  for (int k = 0; k < 200; ++k)
    for (int i = 0; i <= 20; ++i) {
      const double h = 0.02 * k, a = (180 + 9.0 * i) * 3.14159265358979 / 180;
      points.push_back({x + lean * h + radius * std::cos(a), y + radius * std::sin(a), h});
    }
}

TEST(Trunks, TheAxisIsThatOfTheCylinderThoughOneSideIsSeen) {
  for (const double radius : {0.05, 0.15, 0.4})
    for (const double lean : {0.0, 0.05}) {
      std::vector<std::array<double, 3>> points;
      add_trunk_side(4.03, 3.96, radius, lean, points);
      const std::vector<Trunk> trunks = find_trunks(trunk_voxels(points));
      ASSERT_EQ(trunks.size(), 1u) << radius << " " << lean;
      EXPECT_NEAR(trunks[0].x, 4.03, 0.03) << radius << " " << lean;
      EXPECT_NEAR(trunks[0].y, 3.96, 0.03) << radius << " " << lean;
      EXPECT_NEAR(trunks[0].radius, radius, 0.03) << radius << " " << lean;
      EXPECT_LE(trunks[0].from, 0.31);
      EXPECT_GE(trunks[0].to, 3.2);
    }
}

TEST(Trunks, WallsLowPostsAndCrownsAreNone) {
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 400; ++i)
    for (int k = 0; k < 60; ++k) points.push_back({0.5 + 0.01 * i, 1.0, 0.05 * k});  // a wall of 4 m
  for (int k = 0; k < 50; ++k) points.push_back({6, 6, 0.3 + 0.009 * k});            // a bollard of 0.75 m
  Rng rng(1);
  for (int i = 0; i < 4000; ++i)  // leaves
    points.push_back({1 + 5 * rng.uniform(), 3 + 2 * rng.uniform(), 1.5 + 2 * rng.uniform()});
  EXPECT_TRUE(find_trunks(trunk_voxels(points)).empty());
  EXPECT_TRUE(find_trunks(trunk_voxels({})).empty());
}

}  // namespace
}  // namespace ilot
