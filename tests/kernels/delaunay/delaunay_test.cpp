// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/delaunay.h"

#include <gtest/gtest.h>

#include "kernels/core/parallel.h"
#include "kernels/delaunay/topology.h"
#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

using test::placed_triangles;

TEST(Delaunay, FourPointsOfASquareAreCutBehindTheLargest) {
  const std::vector<Point2> points{{1, 1}, {0, 0}, {0, 1}, {1, 0}};
  const Triangulation t = delaunay(points);
  const std::vector<test::PlacedTriangle> expected{test::placed({0, 0}, {1, 0}, {0, 1}),
                                                   test::placed({1, 0}, {1, 1}, {0, 1})};
  EXPECT_EQ(placed_triangles(t, points), expected);
  EXPECT_EQ(std::count(t.twin.begin(), t.twin.end(), kNoEdge), 4);
}

TEST(Delaunay, DuplicatesGoToTheSmallestIndex) {
  const std::vector<Point2> points{{3, 3}, {0, 0}, {9, 0}, {0, 0}, {0, 9}, {3, 3}, {3, 3}};
  const Triangulation t = delaunay(points);
  EXPECT_EQ(t.triangles(), 3u);
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> expected{{3, 1}, {5, 0}, {6, 0}};
  EXPECT_EQ(t.duplicates, expected);
  EXPECT_EQ(check_topology(t, points), TopologyFault::kNone);
}

TEST(Delaunay, EqualsTheTrianglesWithEmptyCircles) {
  for (const std::uint32_t n : {0u, 1u, 2u, 3u, 4u, 5u, 7u, 8u, 9u, 16u, 30u})
    for (std::uint64_t key = 0; key < (n > 10 ? 3u : 20u); ++key)
      for (const auto& set : test::plane_sets(n, 100 * key + n)) {
        SCOPED_TRACE(set.name + " of " + std::to_string(n) + ", key " + std::to_string(key));
        const Triangulation t = delaunay(set.points);
        ASSERT_EQ(check_topology(t, set.points), TopologyFault::kNone);
        ASSERT_EQ(placed_triangles(t, set.points), test::empty_circle_triangles(set.points));
      }
}

TEST(Delaunay, ManyPointsAreSound) {
  for (const std::uint32_t n : {1000u, 100000u})
    for (const auto& set : test::plane_sets(n, n)) {
      SCOPED_TRACE(set.name);
      const Triangulation t = delaunay(set.points);
      EXPECT_EQ(check_topology(t, set.points), TopologyFault::kNone);
      EXPECT_TRUE(is_delaunay(t, set.points));
    }
}

std::vector<Point2> positions(const Triangulation& t, const std::vector<Point2>& points) {
  std::vector<Point2> p;
  for (const std::uint32_t v : t.corner) p.push_back(points[v]);
  return p;
}

TEST(Delaunay, OrderOfPointsAndAShiftChangeNothing) {
  for (auto& set : test::plane_sets(3000, 9)) {
    SCOPED_TRACE(set.name);
    const std::vector<Point2> before = positions(delaunay(set.points), set.points);
    Rng rng(1);
    std::vector<Point2> mixed = set.points;
    for (std::size_t i = mixed.size(); i > 1; --i) std::swap(mixed[i - 1], mixed[rng.below(i)]);
    EXPECT_EQ(positions(delaunay(mixed), mixed), before);
    if (set.name == "far" || set.name == "corners" || set.name == "clusters" || set.name == "near circle") continue;
    for (Point2& p : mixed) p = {p.x - 314159265, p.y + 271828182};
    std::vector<Point2> shifted = positions(delaunay(mixed), mixed);
    for (Point2& p : shifted) p = {p.x + 314159265, p.y - 271828182};
    EXPECT_EQ(shifted, before);
  }
}

TEST(Delaunay, ThreadsChangeNothing) {
  for (const auto& set : test::plane_sets(200000, 4)) {
    SCOPED_TRACE(set.name);
    Triangulation one, other;
    with_threads(1, [&] { one = delaunay(set.points); });
    for (const int threads : {2, 3, 8}) {
      with_threads(threads, [&] { other = delaunay(set.points); });
      EXPECT_EQ(one.corner, other.corner);
      EXPECT_EQ(one.twin, other.twin);
      EXPECT_EQ(one.duplicates, other.duplicates);
    }
  }
}

// A block that knows all points in a triangle's circle has the triangle: ties are no matter of what else is there.
TEST(Delaunay, SubsetsAgreeOnTrianglesWithEmptyCircles) {
  for (const auto& set : test::plane_sets(24, 77)) {
    SCOPED_TRACE(set.name);
    const auto whole = placed_triangles(delaunay(set.points), set.points);
    for (std::size_t left_out = 0; left_out < set.points.size(); ++left_out) {
      std::vector<Point2> rest;
      for (const Point2 p : set.points)
        if (p != set.points[left_out]) rest.push_back(p);
      const auto part = placed_triangles(delaunay(rest), rest);
      for (const auto& t : whole) {
        const bool touched = std::find(t.begin(), t.end(), set.points[left_out]) != t.end();
        EXPECT_TRUE(touched || std::binary_search(part.begin(), part.end(), t));
      }
    }
  }
}

TEST(CheckTopology, FindsEachFault) {
  const std::vector<Point2> points{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 4}};
  const Triangulation right = delaunay(points);
  ASSERT_EQ(check_topology(right, points), TopologyFault::kNone);
  Triangulation t = right;
  t.twin.pop_back();
  EXPECT_EQ(check_topology(t, points), TopologyFault::kArrays);
  t = right;
  t.corner[2] = 5;
  EXPECT_EQ(check_topology(t, points), TopologyFault::kArrays);
  t = right;
  *std::find_if(t.twin.begin(), t.twin.end(), [](std::uint32_t e) { return e != kNoEdge; }) = kNoEdge;
  EXPECT_EQ(check_topology(t, points), TopologyFault::kTwins);
  const std::vector<Point2> turned{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, -4}};
  EXPECT_EQ(check_topology(right, turned), TopologyFault::kOrientation);
  t = right;  // without one triangle: its inner edges become hull
  for (std::uint32_t e = 0; e < 3; ++e)
    if (t.twin[e] != kNoEdge) t.twin[t.twin[e]] = kNoEdge;
  t.corner.erase(t.corner.begin(), t.corner.begin() + 3);
  t.twin.erase(t.twin.begin(), t.twin.begin() + 3);
  for (std::uint32_t& e : t.twin)
    if (e != kNoEdge) e -= 3;
  EXPECT_EQ(check_topology(t, points), TopologyFault::kHull);
  std::vector<Point2> more = points;
  more.push_back({7, 7});
  EXPECT_EQ(check_topology(right, more), TopologyFault::kVertices);
  EXPECT_EQ(check_topology({}, points), TopologyFault::kVertices);
}

}  // namespace
}  // namespace ilot
