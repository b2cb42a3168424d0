// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/edge_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Flags = std::vector<std::uint8_t>;

// The length of the edge that lies in the point's Voronoi cell: the edge cut by the bisector with every other point.
double length_in_cell(const std::vector<FlatPoint>& points, std::size_t i, const FlatEdge& edge) {
  double from = 0, to = 1;
  const FlatPoint along{edge.b.x - edge.a.x, edge.b.y - edge.a.y};
  for (const FlatPoint& q : points) {
    if (q.x == points[i].x && q.y == points[i].y) continue;
    // (|x - p|^2 <= |x - q|^2) is (q - p) . x <= (|q|^2 - |p|^2) / 2, with x = a + t along; all relative to a.
    const double px = points[i].x - edge.a.x, py = points[i].y - edge.a.y;
    const double qx = q.x - edge.a.x, qy = q.y - edge.a.y;
    const double slope = (qx - px) * along.x + (qy - py) * along.y;
    const double limit = (qx * qx + qy * qy - px * px - py * py) / 2;
    if (slope > 0)
      to = std::min(to, limit / slope);
    else if (slope < 0)
      from = std::max(from, limit / slope);
    else if (limit < 0)
      return 0;
  }
  return std::max(0.0, to - from) * std::hypot(along.x, along.y);
}

// Cells cut in less than a hair may go either way.
void expect_as_brute_force(const std::vector<FlatPoint>& points, const std::vector<FlatEdge>& edges) {
  const Flags flags = cells_on_edges(points, edges);
  ASSERT_EQ(flags.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    double most = 0;
    for (const FlatEdge& edge : edges) most = std::max(most, length_in_cell(points, i, edge));
    if (most > 1e-9) {
      EXPECT_TRUE(flags[i]) << i;
    } else if (most == 0) {
      EXPECT_FALSE(flags[i]) << i;
    }
  }
}

TEST(EdgeCells, FlagsTheRowBesideAnEdge) {
  std::vector<FlatPoint> points;
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 5; ++column) points.push_back({column + 0.5, row + 0.5});
  const std::vector<FlatEdge> below{{{0, 0}, {5, 0}}};
  Flags wanted(25, 0);
  std::fill_n(wanted.begin(), 5, 1);
  EXPECT_EQ(cells_on_edges(points, below), wanted);
  // Through the middle of a column, half way up.
  const std::vector<FlatEdge> across{{{2.4, -9}, {2.4, 2.2}}};
  Flags column(25, 0);
  column[2] = column[7] = column[12] = 1;
  EXPECT_EQ(cells_on_edges(points, across), column);
}

TEST(EdgeCells, AgreesWithBruteForceOnRandomSets) {
  Rng rng(5);
  const auto place = [&](double size) {
    const double x = rng.uniform(), y = rng.uniform();
    return FlatPoint{size * x, size * y};
  };
  for (int round = 0; round < 60; ++round) {
    std::vector<FlatPoint> points;
    std::vector<FlatEdge> edges;
    for (int i = 0; i < 1 + round * 7; ++i) points.push_back(place(10));
    for (int i = 0; i < 6; ++i) edges.push_back({place(14), place(14)});
    edges.push_back({{200, 300}, {-100, 250}});  // far from every point
    expect_as_brute_force(points, edges);
  }
}

TEST(EdgeCells, AgreesOnClustersLinesAndFarEdges) {
  Rng rng(6);
  std::vector<FlatPoint> clusters, line;
  for (int i = 0; i < 200; ++i) {
    const double x = rng.uniform(), y = rng.uniform();
    clusters.push_back({x * 0.01 + 100 * (i % 3), y * 0.01});
    line.push_back({10 * x, 0});
  }
  const std::vector<FlatEdge> edges{{{-50, 5}, {260, -3}}, {{100, 0}, {100, 0.02}}};
  expect_as_brute_force(clusters, edges);
  expect_as_brute_force(line, {{{1, 1}, {9, 2}}, {{3, -5}, {3, 5}}});
}

TEST(EdgeCells, DoesNotDependOnTheOrderOfPointsOrTheDirectionOfEdges) {
  Rng rng(7);
  std::vector<FlatPoint> points;
  for (int i = 0; i < 500; ++i) {
    const double x = rng.uniform(), y = rng.uniform();
    points.push_back({x, y});
  }
  const std::vector<FlatEdge> edges{{{0, 0.1}, {1, 0.7}}, {{0.3, 0.9}, {0.2, 0}}};
  const std::vector<FlatEdge> turned{{{0.2, 0}, {0.3, 0.9}}, {{1, 0.7}, {0, 0.1}}};
  const Flags flags = cells_on_edges(points, edges);
  EXPECT_EQ(cells_on_edges(points, turned), flags);
  std::vector<FlatPoint> reversed(points.rbegin(), points.rend());
  Flags back = cells_on_edges(reversed, edges);
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(back, flags);
}

TEST(EdgeCells, TakesWhatIsDegenerate) {
  const std::vector<FlatEdge> edge{{{0, 0}, {1, 0}}}, none{{{1, 1}, {1, 1}}};
  EXPECT_TRUE(cells_on_edges({}, edge).empty());
  const std::vector<FlatPoint> one{{7, 7}}, twins{{7, 7}, {7, 7}, {90, 7}};
  EXPECT_EQ(cells_on_edges(one, edge), Flags{1});
  EXPECT_EQ(cells_on_edges(one, none), Flags{0});
  EXPECT_EQ(cells_on_edges(one, {}), Flags{0});
  EXPECT_EQ(cells_on_edges(twins, edge), (Flags{1, 1, 0}));  // at one place: one cell
}

}  // namespace
}  // namespace ilot
