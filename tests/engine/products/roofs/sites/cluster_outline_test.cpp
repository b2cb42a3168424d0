// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/cluster_outline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/products/roofs/sites/outline_repair.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Ten points a square metre over a house of 12 x 8 m with a courtyard of 3 x 3 m, and a few strays in the yard.
std::vector<Point2> house(std::uint64_t key) {
  Rng rng(key);
  std::vector<Point2> points;
  for (int i = 0; i < 960; ++i) {
    const Point2 p{static_cast<std::int32_t>(rng.below(12000)), static_cast<std::int32_t>(rng.below(8000))};
    if (p.x < 5000 || p.x > 8000 || p.y < 2500 || p.y > 5500) points.push_back(p);
  }
  return points;
}

TEST(ClusterOutline, AHouseWithItsCourtyard) {
  const auto outlines = cluster_outline(house(2));
  ASSERT_EQ(outlines.size(), 1u);
  ASSERT_EQ(outlines[0].size(), 2u);
  EXPECT_NEAR(area_of(outlines[0]), 87, 4);
  const auto [x0, x1] = std::minmax_element(outlines[0][0].begin(), outlines[0][0].end());
  EXPECT_NEAR(x0->x, 0, 250);
  EXPECT_NEAR(x1->x, 12000, 250);
}

TEST(ClusterOutline, DependsOnThePositionsAlone) {
  auto points = house(3);
  const auto outlines = cluster_outline(points);
  std::reverse(points.begin(), points.end());
  points.insert(points.end(), points.begin(), points.begin() + 100);
  EXPECT_EQ(cluster_outline(points), outlines);
}

TEST(ClusterOutline, NoneWherePointsEncloseNothing) {
  EXPECT_TRUE(cluster_outline({}).empty());
  std::vector<Point2> line;
  for (int i = 0; i < 200; ++i) line.push_back({100 * i, 37 * i});
  EXPECT_TRUE(cluster_outline(line).empty()) << "all points of a roof on one line";
  EXPECT_TRUE(cluster_outline(std::vector<Point2>(500, Point2{7, 7})).empty());
}

TEST(ClusterOutline, ManyPointsAreThinned) {
  Rng rng(4);
  std::vector<Point2> points;
  for (int i = 0; i < 400000; ++i)
    points.push_back({static_cast<std::int32_t>(rng.below(20000)), static_cast<std::int32_t>(rng.below(15000))});
  const auto outlines = cluster_outline(points);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_NEAR(area_of(outlines[0]), 300, 3);
}

}  // namespace
}  // namespace ilot
