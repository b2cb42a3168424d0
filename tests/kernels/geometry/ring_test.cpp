// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry/ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

const std::vector<Point2> kShapeL{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 4}, {0, 4}};

std::vector<FlatPoint> in_doubles(const std::vector<Point2>& ring) {
  std::vector<FlatPoint> flat;
  for (const Point2 p : ring) flat.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  return flat;
}

// Corners at random on a small lattice, some triangles without area.
std::vector<Point2> triangle_of(Rng& rng) {
  std::vector<Point2> ring;
  for (int i = 0; i < 3; ++i)
    ring.push_back({static_cast<std::int32_t>(rng.below(12)), static_cast<std::int32_t>(rng.below(12))});
  return ring;
}

TEST(Ring, AreaOfAnL) {
  std::vector<Point2> ring = kShapeL;
  EXPECT_TRUE(doubled_area(ring) == 32);
  EXPECT_EQ(doubled_area(in_doubles(ring)), 32);
  std::rotate(ring.begin(), ring.begin() + 4, ring.end());
  std::reverse(ring.begin(), ring.end());
  EXPECT_TRUE(doubled_area(ring) == -32);
  EXPECT_EQ(doubled_area(in_doubles(ring)), -32);
  EXPECT_TRUE(doubled_area(std::span<const Point2>()) == 0);
}

TEST(Ring, AreaInSpaceIsAlongTheNormal) {
  const std::vector<Vec3> ring{{5, 1, 1}, {5, 4, 1}, {5, 4, 3}, {5, 1, 3}};
  const Vec3 area = doubled_area(ring);
  EXPECT_EQ(area.x, 12);
  EXPECT_EQ(area.y, 0);
  EXPECT_EQ(area.z, 0);
}

TEST(Ring, LowerAndLeftBordersAreInside) {
  EXPECT_TRUE(contains(kShapeL, {0, 0}));
  EXPECT_TRUE(contains(kShapeL, {0, 3}));
  EXPECT_TRUE(contains(kShapeL, {5, 0}));
  EXPECT_FALSE(contains(kShapeL, {6, 1}));
  EXPECT_FALSE(contains(kShapeL, {1, 4}));
  EXPECT_FALSE(contains(kShapeL, {4, 2}));
  EXPECT_FALSE(contains(kShapeL, {2, 3}));
  EXPECT_FALSE(contains(kShapeL, {7, 1}));
}

// By the signs of the three corners alone.
TEST(Ring, PointsOffTheBorderAreWhereTheirSidesSay) {
  Rng rng(11);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Point2> ring = triangle_of(rng);
    for (std::int32_t y = 0; y < 12; ++y)
      for (std::int32_t x = 0; x < 12; ++x) {
        const Point2 p{x, y};
        int left = 0, on = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int64_t side = orient2d(ring[i], ring[(i + 1) % 3], p);
          left += side > 0, on += side == 0;
        }
        if (on > 0) continue;
        const FlatPoint flat{static_cast<double>(x), static_cast<double>(y)};
        EXPECT_EQ(contains(ring, p), left == 3 || left == 0);
        EXPECT_EQ(contains_by_share(in_doubles(ring), flat), left == 3 || left == 0);
      }
  }
}

TEST(Ring, OneOfTwoNeighboursHoldsWhatLiesOnTheirEdge) {
  Rng rng(12);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Point2> ring = triangle_of(rng);
    const Point2 low{-20, -20}, right{50, -20}, high{-20, 50};
    // The big triangle is the sum of those over its sides seen from any place inside: each point is in one of them.
    const Point2 centre = ring[0];
    int holders = 0;
    for (const auto& [a, b] : {std::pair{low, right}, {right, high}, {high, low}})
      holders += contains(std::vector{centre, a, b}, ring[1]);
    EXPECT_EQ(holders, 1);
  }
}

TEST(Ring, BothWaysRoundTheRayCrossesAlike) {
  Rng rng(13);
  const auto draw = [&] { return FlatPoint{rng.uniform(), rng.uniform()}; };
  for (int i = 0; i < 1000; ++i) {
    const FlatPoint p = draw(), a = draw(), b = draw();
    EXPECT_EQ(ray_crosses(p, a, b), ray_crosses(p, b, a));
    EXPECT_EQ(ray_crosses(p, a, b), ray_crosses_by_share(p, a, b));  // none is so near that rounding decides
  }
}

TEST(Ring, EdgesLeadBackToTheFirstCorner) {
  std::vector<FlatEdge> edges;
  add_ring(in_doubles(kShapeL), edges);
  ASSERT_EQ(edges.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(distance(edges[i].b, edges[(i + 1) % 6].a), 0);
}

}  // namespace
}  // namespace ilot
