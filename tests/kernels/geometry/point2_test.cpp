// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry/point2.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TEST(Point2, OrientationIsExactAtTheLimit) {
  constexpr std::int32_t m = kMaxPlaneCoordinate;
  EXPECT_EQ(orient2d(Point2{-m, -m}, Point2{m, -m}, Point2{m, m}), std::int64_t{1} << 60);
  EXPECT_EQ(orient2d(Point2{-m, -m}, Point2{m, m}, Point2{m - 1, m - 1}), 0);
  EXPECT_EQ(orient2d(Point2{-m, -m}, Point2{m, m}, Point2{m - 1, m}), std::int64_t{1} << 30);
  EXPECT_EQ(squared_distance(Point2{-m, -m}, Point2{m, m}), std::int64_t{1} << 61);
}

TEST(Point2, HalvesGoAwayFromZero) {
  EXPECT_EQ(lattice_point({0.5, -0.5}, 1), (Point2{1, -1}));
  EXPECT_EQ(lattice_point({1.2344, -1.2346}, 1000), (Point2{1234, -1235}));
}

}  // namespace
}  // namespace ilot
