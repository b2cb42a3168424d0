// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/shown_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ilot {
namespace {

// A row of points over a ridge at y = 5, 0.25 m apart: the plane in the front has those up to y = 6, the other one the
// rest. Each point is a neighbour of the two beside it.
struct Row {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> lists;
  RoofPlanes planes;

  Row() {
    planes.planes = {{0, 0.1, 0, 10, -10, 0}, {0, -0.1, 1, 10, -10, 0}};
    planes.epsilon = 0.05;
    for (int i = 0; i <= 40; ++i) {
      const double y = 0.25 * i;
      points.push_back({0, y, std::min(0.1 * y, 1 - 0.1 * y)});
      planes.of_point.push_back(y <= 6 ? 1 : 2);
      RoofPlane& own = planes.planes[planes.of_point.back() - 1];
      own.lowest = std::min(own.lowest, points.back().z);
      own.highest = std::max(own.highest, points.back().z);
      const auto last = i == 0 ? 1u : static_cast<std::uint32_t>(i - 1);
      lists.insert(lists.end(), {last, i == 40 ? last : static_cast<std::uint32_t>(i + 1)});
    }
    planes.on_wall.assign(points.size(), 0);
  }
};

TEST(ShownHeights, PointsOfANeighbourWithinEpsilonShowAPlane) {
  Row row;
  ASSERT_NEAR(row.planes.planes[1].highest, 0.375, 1e-9);
  widen_heights(row.points, {row.lists, 2}, RunNeighbours(row.points.size(), {row.lists, 2}), row.planes);
  EXPECT_NEAR(row.planes.planes[0].highest, 0.5, 1e-9);
  EXPECT_NEAR(row.planes.planes[1].highest, 0.5, 1e-9) << "up to the ridge";
  EXPECT_NEAR(row.planes.planes[1].lowest, 0, 1e-9);
}

TEST(ShownHeights, PointsOfWallsAndBeyondAGapShowNothing) {
  Row row;
  row.planes.on_wall[24] = 1;  // the first point of the front plane, seen from the other one
  widen_heights(row.points, {row.lists, 2}, RunNeighbours(row.points.size(), {row.lists, 2}), row.planes);
  EXPECT_NEAR(row.planes.planes[1].highest, 0.375, 1e-9);
}

}  // namespace
}  // namespace ilot
