// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/hull.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

TEST(ConvexHull, LeavesOutPointsOnEdgesAndDuplicates) {
  const std::vector<Point2> points{{2, 2}, {4, 0}, {0, 0}, {2, 0}, {4, 4}, {0, 0}, {0, 4}, {4, 2}};
  EXPECT_EQ(convex_hull(points), (std::vector<std::uint32_t>{2, 1, 4, 6}));
}

TEST(ConvexHull, OfFewPointsAndOfPointsOnALine) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_EQ(convex_hull(std::vector<Point2>(3, {7, 7})), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(convex_hull(std::vector<Point2>{{2, 2}, {1, 1}, {3, 3}}), (std::vector<std::uint32_t>{1, 2}));
}

// Edges that have all other points on their left or between their ends, by definition.
std::size_t hull_edges(std::vector<Point2> p) {
  std::sort(p.begin(), p.end());
  p.erase(std::unique(p.begin(), p.end()), p.end());
  std::size_t count = 0;
  for (const Point2 a : p)
    for (const Point2 b : p)
      count += a != b && std::all_of(p.begin(), p.end(), [&](Point2 c) {
                 const std::int64_t turn = orient2d(a, b, c);
                 return turn > 0 || (turn == 0 && std::min(a, b) <= c && c <= std::max(a, b));
               });
  return count;
}

TEST(ConvexHull, EqualsItsDefinition) {
  for (std::uint64_t key = 0; key < 20; ++key)
    for (const auto& set : test::plane_sets(30, key)) {
      SCOPED_TRACE(set.name);
      const auto hull = convex_hull(set.points);
      if (hull.size() < 3) continue;
      EXPECT_EQ(hull.size(), hull_edges(set.points));
      for (std::size_t i = 0; i < hull.size(); ++i)
        for (const Point2 p : set.points)
          EXPECT_GE(orient2d(set.points[hull[i]], set.points[hull[(i + 1) % hull.size()]], p), 0);
    }
}

// Corners lie within 2^30 and are rounded a few times at 2^-52 of that.
constexpr double kRounding = 0x1p-19;

double area_along(const std::vector<Point2>& points, Point2 a, Point2 b) {
  double low = 1e300, high = -1e300, bottom = 1e300, top = -1e300;
  for (const Point2 p : points) {
    const double x = b.x - a.x, y = b.y - a.y, u = p.x - a.x, v = p.y - a.y;
    low = std::min(low, u * x + v * y);
    high = std::max(high, u * x + v * y);
    bottom = std::min(bottom, v * x - u * y);
    top = std::max(top, v * x - u * y);
  }
  return (high - low) * (top - bottom) / (std::pow(b.x - a.x, 2) + std::pow(b.y - a.y, 2));
}

TEST(RightAngledOutline, OfALeaningStone) {
  const std::vector<Point2> points{{0, 0}, {40, 30}, {34, 38}, {-6, 8}, {10, 10}};
  const auto outline = right_angled_outline(convex_hull(points), points);
  const double expected[4][2]{{-6, 8}, {0, 0}, {40, 30}, {34, 38}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(outline[i].x, expected[i][0], 1e-12);
    EXPECT_NEAR(outline[i].y, expected[i][1], 1e-12);
  }
}

TEST(RightAngledOutline, ContainsAllPointsInTheLeastArea) {
  for (std::uint64_t key = 0; key < 20; ++key)
    for (const auto& set : test::plane_sets(30, key)) {
      SCOPED_TRACE(set.name);
      const auto hull = convex_hull(set.points);
      const auto box = right_angled_outline(hull, set.points);
      if (hull.size() < 3) continue;
      double least = 1e300;
      for (std::size_t i = 0; i < hull.size(); ++i)
        least = std::min(least, area_along(set.points, set.points[hull[i]], set.points[hull[(i + 1) % hull.size()]]));
      double area = 0, tolerance = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const PlanePosition a = box[i], b = box[(i + 1) % 4], c = box[(i + 2) % 4];
        const double x = b.x - a.x, y = b.y - a.y, length = std::hypot(x, y);
        const double side = std::hypot(c.x - b.x, c.y - b.y);
        EXPECT_NEAR(x * (c.x - b.x) + y * (c.y - b.y), 0, kRounding * (length + side));
        for (const Point2 p : set.points) EXPECT_GE(x * (p.y - a.y) - y * (p.x - a.x), -kRounding * 0x1p30);
        if (i == 0) {
          area = length * side;
          tolerance = kRounding * (length + side);
        }
      }
      EXPECT_NEAR(area, least, tolerance);
    }
}

}  // namespace
}  // namespace ilot
