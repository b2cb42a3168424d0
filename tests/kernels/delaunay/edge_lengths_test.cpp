// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/edge_lengths.h"

#include <gtest/gtest.h>

#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

TEST(EdgeLengths, EdgesOfALatticeWithAHoleChangeTheirSlopeAtTheHole) {
  std::vector<Point2> points;
  for (std::int32_t x = 0; x < 40; ++x)
    for (std::int32_t y = 0; y < 40; ++y)
      if (x < 15 || x > 24 || y < 15 || y > 24) points.push_back({10 * x, 10 * y});
  const Triangulation t = delaunay(points);
  const double threshold = slope_change(t, points);
  EXPECT_GE(threshold, 14.14);  // the lattice's diagonal
  EXPECT_LT(threshold, 28);
  const auto end = ends_of_long_edges(t, points, threshold);
  int inner = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t x = points[i].x / 10, y = points[i].y / 10;
    const bool beside = x >= 14 && x <= 25 && y >= 14 && y <= 25;
    if (!beside) {
      EXPECT_EQ(end[i], 0) << x << " " << y;
    } else {
      inner += end[i];
    }
  }
  EXPECT_GE(inner, 36);  // of the 44 around the hole: in each corner short edges may shut off two
}

TEST(EdgeLengths, EqualEdgesAndNoEdgesHaveNoLongOnes) {
  const std::vector<Point2> line{{0, 0}, {1, 0}, {2, 0}};
  EXPECT_EQ(slope_change(delaunay(line), line), 0.5);
  const std::vector<Point2> corner{{0, 0}, {3, 0}, {0, 4}};
  const Triangulation t = delaunay(corner);
  const auto end = ends_of_long_edges(t, corner, 4.5);
  EXPECT_EQ(end, (std::vector<std::uint8_t>{0, 1, 1}));
}

TEST(EdgeLengths, EndsByDefinition) {
  for (const auto& set : test::plane_sets(200, 5)) {
    const Triangulation t = delaunay(set.points);
    const double threshold = slope_change(t, set.points);
    const auto end = ends_of_long_edges(t, set.points, threshold);
    std::vector<std::uint8_t> expected(set.points.size());
    for (std::uint32_t e = 0; e < t.corner.size(); ++e) {
      const std::uint32_t a = t.corner[e], b = t.corner[next_edge(e)];
      const double d2 = static_cast<double>(squared_distance(set.points[a], set.points[b]));
      if (d2 > threshold * threshold) expected[a] = expected[b] = 1;
    }
    EXPECT_EQ(end, expected) << set.name;
  }
}

}  // namespace
}  // namespace ilot
