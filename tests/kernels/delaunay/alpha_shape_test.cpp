// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/alpha_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

using test::PlacedTriangle;

std::vector<PlacedTriangle> placed_of(const Triangulation& t, const std::vector<Point2>& points,
                                      const std::vector<std::uint32_t>& triangles) {
  std::vector<PlacedTriangle> all;
  for (const std::uint32_t i : triangles)
    all.push_back(test::placed(points[t.corner[3 * i]], points[t.corner[3 * i + 1]], points[t.corner[3 * i + 2]]));
  return all;
}

std::vector<PlacedTriangle> shape_of(const std::vector<Point2>& points, const ShapeParams& params) {
  const Triangulation t = delaunay(points);
  const std::vector<std::uint8_t> keep = shape_triangles(t, points, params);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < keep.size(); ++i)
    if (keep[i]) kept.push_back(i);
  auto all = placed_of(t, points, kept);
  std::sort(all.begin(), all.end());
  return all;
}

TEST(AlphaShape, TheCircleOfARightTriangleHasHalfItsLongestEdgeAsRadius) {
  const std::vector<Point2> points{{0, 0}, {30, 0}, {0, 40}};
  const Triangulation t = delaunay(points);
  for (const float reach : {24.9f, 25.0f}) {
    const std::vector<float> all(3, reach);
    EXPECT_EQ(shape_triangles(t, points, {TriangleRule::kCircumradius, all})[0], reach == 25.0f);
  }
  for (const float reach : {49.9f, 50.0f}) {
    const std::vector<float> all(3, reach);
    EXPECT_EQ(shape_triangles(t, points, {TriangleRule::kLongestEdge, all})[0], reach == 50.0f);
  }
}

TEST(AlphaShape, ATriangleTakesTheLargestReachOfItsCorners) {
  const std::vector<Point2> points{{0, 0}, {30, 0}, {0, 40}};
  const Triangulation t = delaunay(points);
  const std::vector<float> reach{1, 2, 25};
  EXPECT_EQ(shape_triangles(t, points, {TriangleRule::kCircumradius, reach})[0], 1);
  EXPECT_EQ(owner(t, 0, points, reach), 2u);
  EXPECT_EQ(owner(t, 0, points, std::vector<float>{7, 7, 7}), 0u);
}

TEST(AlphaShape, ASliverIsDroppedWhateverItsEdges) {
  const std::vector<Point2> points{{0, 0}, {100, 0}, {50, 1}};
  const Triangulation t = delaunay(points);
  EXPECT_EQ(shape_triangles(t, points, {TriangleRule::kLongestEdge, std::vector<float>(3, 100.0f)})[0], 0);
}

TEST(AlphaShape, HeightsLengthenEdgesAndLabelsPart) {
  const std::vector<Point2> points{{0, 0}, {30, 0}, {0, 40}};
  const Triangulation t = delaunay(points);
  const std::vector<float> reach(3, 50.0f);
  const std::vector<std::int32_t> flat{5, 5, 5}, step{5, 6, 5};
  const std::vector<std::uint32_t> same{2, 2, 2}, other{2, 2, 3};
  EXPECT_EQ(shape_triangles(t, points, {TriangleRule::kLongestEdge, reach, flat, same})[0], 1);
  EXPECT_EQ(shape_triangles(t, points, {TriangleRule::kLongestEdge, reach, step, same})[0], 0);
  EXPECT_EQ(shape_triangles(t, points, {TriangleRule::kLongestEdge, reach, flat, other})[0], 0);
}

TEST(AlphaShape, RadiusAgreesWithLongDoubles) {
  Rng rng(3);
  std::size_t kept = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Point2> p(3);
    for (Point2& q : p) q = {test::draw_within(rng, 1000), test::draw_within(rng, 1000)};
    const Triangulation t = delaunay(p);
    if (t.triangles() == 0) continue;
    long double product = 1;
    for (std::size_t k = 0; k < 3; ++k)
      product *= std::sqrt(static_cast<long double>(squared_distance(p[k], p[(k + 1) % 3])));
    const long double radius = product / (2 * std::abs(static_cast<long double>(orient2d(p[0], p[1], p[2]))));
    for (const long double factor : {0.9999L, 1.0001L}) {
      const std::vector<float> reach(3, static_cast<float>(radius * factor));
      EXPECT_EQ(shape_triangles(t, p, {TriangleRule::kCircumradius, reach})[0], factor > 1) << radius;
      kept += factor > 1;
    }
  }
  EXPECT_GT(kept, 1900u);
}

// Points in blocks, the reach of each, and what comes out of block by block with nothing but its halo.
struct Blocks {
  std::vector<Point2> points;
  std::vector<float> reach;
  std::vector<std::uint32_t> block;
  std::uint32_t count = 0;
};

std::vector<PlacedTriangle> joined(const Blocks& b, TriangleRule rule) {
  std::vector<PlacedTriangle> all;
  for (std::uint32_t k = 0; k < b.count; ++k) {
    std::vector<float> own_reach = b.reach;
    std::vector<std::uint8_t> of_block;
    for (std::size_t i = 0; i < b.points.size(); ++i) {
      of_block.push_back(b.block[i] == k);
      if (b.block[i] != k) own_reach[i] = -1;
    }
    const std::vector<std::uint8_t> needed = needed_points(rule, b.points, own_reach, of_block);
    std::vector<Point2> near;
    std::vector<float> reach;
    std::vector<std::uint8_t> own;
    for (std::size_t i = 0; i < b.points.size(); ++i) {
      if (!needed[i]) continue;
      near.push_back(b.points[i]);
      reach.push_back(b.reach[i]);
      own.push_back(of_block[i]);
    }
    const Triangulation t = delaunay(near);
    const auto part = placed_of(t, near, owned_triangles(t, near, {rule, reach}, own));
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

// Lattices full of cocircular points and random points, local reaches, cut into cells of several sizes and into blocks
// of no shape at all.
TEST(AlphaShape, BlocksJoinToTheWhole) {
  Rng rng(12);
  for (int round = 0; round < 12; ++round) {
    Blocks b;
    const bool lattice = round % 2 == 0;
    for (std::int32_t i = 0; i < 900; ++i) {
      const Point2 p =
          lattice ? Point2{i % 30 * 10, i / 30 * 10} : Point2{test::draw_within(rng, 150), test::draw_within(rng, 150)};
      if (lattice && rng.below(5) == 0) continue;
      if (std::find(b.points.begin(), b.points.end(), p) != b.points.end()) continue;
      b.points.push_back(p);
      b.reach.push_back(round < 4 ? 8.0f : static_cast<float>(4 + rng.below(12)));
    }
    const std::vector<float> radii = b.reach;
    for (const TriangleRule rule : {TriangleRule::kCircumradius, TriangleRule::kLongestEdge}) {
      for (std::size_t i = 0; i < radii.size(); ++i)
        b.reach[i] = rule == TriangleRule::kCircumradius ? radii[i] : 2 * radii[i];
      const auto whole = shape_of(b.points, {rule, b.reach});
      ASSERT_GT(whole.size(), 100u);
      for (const std::int32_t cell : {47, 90, 1000, 0}) {
        b.count = cell == 0 ? 3 : 64;
        b.block.clear();
        for (const Point2 p : b.points)
          b.block.push_back(cell == 0 ? static_cast<std::uint32_t>(rng.below(3))
                                      : static_cast<std::uint32_t>((p.x + 160) / cell * 8 + (p.y + 160) / cell) % 64);
        EXPECT_EQ(joined(b, rule), whole) << "round " << round << ", cells of " << cell;
      }
    }
  }
}

TEST(AlphaShape, ABlockNeedsAllWithinItsHaloAndNotMuchBeside) {
  Rng rng(9);
  std::vector<Point2> points;
  std::vector<float> reach;
  std::vector<std::uint8_t> own;
  for (int i = 0; i < 4000; ++i) {
    points.push_back({test::draw_within(rng, 5000), test::draw_within(rng, 5000)});
    own.push_back(points.back().x < -4000 && points.back().y < -4000);
    reach.push_back(static_cast<float>(rng.below(20) == 0 ? 600 : 100));
  }
  for (const TriangleRule rule : {TriangleRule::kCircumradius, TriangleRule::kLongestEdge}) {
    const auto needed = needed_points(rule, points, reach, own);
    std::int64_t asked = 0, given = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool within = false;
      for (std::size_t k = 0; k < points.size() && !within; ++k) {
        const std::int64_t halo = shape_halo(rule, static_cast<double>(reach[k]));
        within = own[k] && squared_distance(points[i], points[k]) <= halo * halo;
      }
      EXPECT_TRUE(!within || needed[i]);
      asked += within;
      given += needed[i];
    }
    EXPECT_LT(given, 2 * asked);
  }
}

TEST(AlphaShape, EnclosedTrianglesAreKeptWhenErodingFromOutside) {
  // A lattice of 9 x 9 with a hole in the middle and a bay at the side.
  std::vector<Point2> points;
  for (std::int32_t x = 0; x < 9; ++x)
    for (std::int32_t y = 0; y < 9; ++y)
      if (!(x >= 3 && x <= 5 && y >= 3 && y <= 5) && !(x >= 7 && y == 4)) points.push_back({10 * x, 10 * y});
  const Triangulation t = delaunay(points);
  const std::vector<float> reach(points.size(), 7.2f);
  std::vector<std::uint8_t> keep = shape_triangles(t, points, {TriangleRule::kCircumradius, reach});
  const auto count = [&] { return std::count(keep.begin(), keep.end(), 1); };
  EXPECT_EQ(count(), 128 - (32 - 4) - (8 - 2));  // half a cell stays in each inner corner
  keep_enclosed(t, keep);
  std::int64_t area = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) area += orient2d(points[t.corner[3 * i]], points[t.corner[3 * i + 1]], points[t.corner[3 * i + 2]]);
  EXPECT_EQ(area, 2 * (6400 - 400 + 100));  // the bay of 2 x 2 cells stays open, the hole of 4 x 4 does not
}

}  // namespace
}  // namespace ilot
