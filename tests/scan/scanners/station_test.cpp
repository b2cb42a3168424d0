// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/station.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ilot::scan {
namespace {

TEST(Station, AimsFormARightHandedFrame) {
  StationParams params;
  params.forward = {0.6, 0.8, 0};
  params.step_horizontal_deg = 7;
  params.step_vertical_deg = 5;
  params.window = {-60, 60, -40, 50};
  const StationGrid grid(params);
  for (std::uint64_t column = 0; column < grid.columns(); ++column)
    for (std::uint64_t row = 0; row < grid.rows(); ++row) {
      const Aim aim = grid.aim(grid.azimuth(column), row);
      EXPECT_NEAR(norm(aim.axis), 1, 1e-12);
      EXPECT_NEAR(norm(aim.right), 1, 1e-12);
      EXPECT_NEAR(norm(aim.up - cross(aim.right, aim.axis)), 0, 1e-12);
      EXPECT_NEAR(aim.right.z, 0, 1e-12);
    }
}

TEST(Station, AnglesAreWholeStepsWhateverTheWindow) {
  StationParams narrow;
  narrow.step_horizontal_deg = narrow.step_vertical_deg = 0.5;
  narrow.window = {-3, 3, -2, 2};
  StationParams wide = narrow;
  wide.window = {-10, 10, -10, 10};
  const StationGrid a(narrow), b(wide);
  const std::uint64_t columns = 14, rows = 16;  // between the two windows' lower left corners
  for (std::uint64_t i = 0; i < a.rows(); ++i) {
    const Vec3 one = a.aim(a.azimuth(0), i).axis, other = b.aim(b.azimuth(columns), i + rows).axis;
    EXPECT_EQ(one.x, other.x);
    EXPECT_EQ(one.z, other.z);
    EXPECT_EQ(a.key(0, i), b.key(columns, i + rows));
  }
  EXPECT_NE(a.key(0, 1), a.key(1, 0));
}

TEST(Station, TheWindowContainsTheWholeTarget) {
  const Box3<Vec3> box{{-2, 5, -1}, {9, 8, 12}};
  for (Vec3 eye : {Vec3{0, 0, 1.6}, Vec3{-15, 3, 1.6}, Vec3{4, 30, 20}, Vec3{4, 4.5, 5}}) {
    const StationParams station = station_towards(1, eye, box, 0.1);
    const Vec3 right{station.forward.y, -station.forward.x, 0};
    for (double x : {box.min.x, 3.0, box.max.x})
      for (double y : {box.min.y, box.max.y})
        for (double z : {box.min.z, box.max.z}) {
          const Vec3 way = Vec3{x, y, z} - eye;
          const double azimuth = std::atan2(dot(way, right), dot(way, station.forward)) * 57.29577951308232;
          const double flat = std::sqrt(way.x * way.x + way.y * way.y);
          const double elevation = std::atan2(way.z, flat) * 57.29577951308232;
          EXPECT_GE(azimuth, station.window.left - 1e-6);
          EXPECT_LE(azimuth, station.window.right + 1e-6);
          EXPECT_GE(elevation, station.window.low - 1e-6);
          EXPECT_LE(elevation, station.window.high + 1e-6);
        }
  }
}

}  // namespace
}  // namespace ilot::scan
