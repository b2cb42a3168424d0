// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/place_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "kernels/delaunay/place_neighbours_body.h"
#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

std::int64_t brute_force(const std::vector<Point2>& places, std::uint32_t query, int k, std::int64_t farthest) {
  std::vector<std::int64_t> squared;
  for (const Point2 p : places) squared.push_back(squared_distance(p, places[query]));
  std::sort(squared.begin(), squared.end());
  const auto at = static_cast<std::size_t>(k);
  return at < squared.size() && squared[at] <= farthest * farthest ? squared[at] : -1;
}

void expect_brute_force(const std::vector<Point2>& points) {
  const PlaneOrder order = plane_order(points);
  const PlaceCells cells = place_cells(order);
  std::vector<std::uint32_t> queries(order.points.size());
  std::iota(queries.begin(), queries.end(), 0u);
  std::vector<std::int64_t> squared(queries.size());
  for (const int k : {1, 6, 7, 8, 20})
    for (const std::int64_t farthest : {1, 40, 3000, 1 << 22}) {
      kth_distances(cells, queries, k, farthest, squared);
      for (const std::uint32_t q : queries)
        ASSERT_EQ(squared[q], brute_force(order.points, q, k, farthest)) << "k " << k << ", " << farthest;
    }
}

TEST(PlaceNeighbours, EqualBruteForce) {
  for (const std::size_t n : {1u, 2u, 7u, 8u, 300u})
    for (const auto& set : test::plane_sets(n, 5)) {
      if (set.points.empty()) continue;
      const auto [left, right] = std::minmax_element(set.points.begin(), set.points.end());
      const auto by_y = [](Point2 a, Point2 b) { return a.y < b.y; };
      const auto [low, high] = std::minmax_element(set.points.begin(), set.points.end(), by_y);
      if (right->x - left->x >= 1 << 24 || high->y - low->y >= 1 << 24) continue;
      SCOPED_TRACE(set.name + ", " + std::to_string(n));
      expect_brute_force(set.points);
    }
}

// Cells are as wide as most places need: for the others the tree answers.
TEST(PlaceNeighbours, EqualBruteForceWhereTheDensityJumps) {
  Rng rng(8);
  std::vector<Point2> points;
  for (int i = 0; i < 500; ++i) points.push_back({test::draw_within(rng, 20), test::draw_within(rng, 20)});
  for (int i = 0; i < 60; ++i) points.push_back({test::draw_within(rng, 40000), test::draw_within(rng, 40000)});
  for (int i = 0; i < 60; ++i) points.push_back({test::draw_within(rng, 1 << 22), 0});
  expect_brute_force(points);
}

// Also which queries are left to the tree.
TEST(PlaceNeighbours, BodiesAgree) {
  Rng rng(5);
  std::vector<Point2> points;
  for (int i = 0; i < 3000; ++i) points.push_back({test::draw_within(rng, 30000), test::draw_within(rng, 3000)});
  for (int i = 0; i < 500; ++i) points.push_back({test::draw_within(rng, 40), test::draw_within(rng, 40)});
  for (int i = 0; i < 60; ++i) points.push_back({test::draw_within(rng, 1 << 22), test::draw_within(rng, 1 << 22)});
  const PlaneOrder order = plane_order(points);
  const PlaceCells c = place_cells(order);
  std::vector<std::uint32_t> queries(order.points.size());
  std::iota(queries.begin(), queries.end(), 0u);
  std::vector<std::int64_t> expected(queries.size()), squared(queries.size());
  simd::PlaceNeighboursArgs args{
      c.x.data(),     c.y.data(), c.start.data(), c.places.data(), c.low, c.shift,
      c.columns,      c.rows,     queries.data(), queries.size(),  6,     std::int64_t{1} << 40,
      expected.data()};
  simd::kPlaceNeighbours.of(simd::Isa::baseline).in_cells(args);
  EXPECT_GT(std::count(expected.begin(), expected.end(), simd::kNotInCells), 0);
  args.squared = squared.data();
  for (const simd::Isa isa : simd::kIsas) {
    if (!simd::has_isa(isa)) continue;
    simd::kPlaceNeighbours.of(isa).in_cells(args);
    EXPECT_EQ(squared, expected) << simd::name_of(isa);
  }
}

TEST(PlaceNeighbours, CellsHoldEveryPlaceOnce) {
  Rng rng(3);
  std::vector<Point2> points;
  for (int i = 0; i < 2000; ++i) points.push_back({test::draw_within(rng, 9000), test::draw_within(rng, 900)});
  const PlaneOrder order = plane_order(points);
  const PlaceCells cells = place_cells(order);
  std::vector<Point2> held;
  for (std::size_t c = 0; c + 1 < cells.start.size(); ++c)
    for (std::uint32_t i = cells.start[c]; i < cells.start[c + 1]; ++i) {
      const auto x = static_cast<std::int32_t>(cells.x[i]), y = static_cast<std::int32_t>(cells.y[i]);
      EXPECT_EQ(static_cast<std::size_t>((y >> cells.shift) * cells.columns + (x >> cells.shift)), c);
      held.push_back({x + cells.low.x, y + cells.low.y});
    }
  std::vector<Point2> all = order.points;
  std::sort(all.begin(), all.end());
  std::sort(held.begin(), held.end());
  EXPECT_EQ(held, all);
}

}  // namespace
}  // namespace ilot
