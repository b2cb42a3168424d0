// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/constrained.h"

#include <gtest/gtest.h>

#include "kernels/delaunay/rings.h"
#include "kernels/delaunay/topology.h"
#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

bool is_fixed_edge(const Triangulation& t, const Constraints& c, std::uint32_t a, std::uint32_t b) {
  for (std::uint32_t e = 0; e < t.corner.size(); ++e)
    if (c.fixed[e] && t.corner[e] == a && t.corner[next_edge(e)] == b) return true;
  return false;
}

// Sound, each segment made of fixed edges, fixed on both sides, and Delaunay everywhere else.
void expect_constrained(const Triangulation& t, const Constraints& c, const std::vector<Point2>& points,
                        const std::vector<VertexPair>& segments) {
  ASSERT_EQ(check_topology(t, points), TopologyFault::kNone);
  for (std::uint32_t e = 0; e < t.corner.size(); ++e) {
    if (t.twin[e] == kNoEdge) continue;
    EXPECT_EQ(c.fixed[e], c.fixed[t.twin[e]]);
    EXPECT_TRUE(c.fixed[e] || !in_circle(points[t.corner[e]], points[t.corner[next_edge(e)]],
                                         points[t.corner[previous_edge(e)]], points[far_corner(t, e)]));
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(segments.size(), c.crossing); ++i) {
    const auto [a, b] = segments[i];
    std::vector<std::pair<std::int64_t, std::uint32_t>> on;
    for (const std::uint32_t v : t.corner)
      if (orient2d(points[a], points[b], points[v]) == 0 && std::min(points[a], points[b]) <= points[v] &&
          points[v] <= std::max(points[a], points[b]))
        on.emplace_back(squared_distance(points[a], points[v]), v);
    std::sort(on.begin(), on.end());
    on.erase(std::unique(on.begin(), on.end()), on.end());
    for (std::size_t k = 0; k + 1 < on.size(); ++k)
      EXPECT_TRUE(is_fixed_edge(t, c, on[k].second, on[k + 1].second) ||
                  is_fixed_edge(t, c, on[k + 1].second, on[k].second));
  }
}

TEST(Constrained, ASegmentAcrossASquare) {
  const std::vector<Point2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Triangulation t = delaunay(points);
  const std::vector<VertexPair> segments{{0, 2}};
  const Constraints c = insert_segments(t, points, segments);
  EXPECT_EQ(c.crossing, kNoEdge);
  EXPECT_TRUE(is_fixed_edge(t, c, 0, 2));
  expect_constrained(t, c, points, segments);
  const std::vector<VertexPair> both{{0, 2}, {1, 3}};
  t = delaunay(points);
  EXPECT_EQ(insert_segments(t, points, both).crossing, 1u);
}

TEST(Constrained, RandomSegmentsOverAnyPoints) {
  std::size_t crossing = 0, long_ones = 0;
  for (std::uint64_t key = 0; key < 60; ++key)
    for (const auto& set : test::plane_sets(30, key)) {
      SCOPED_TRACE(set.name + ", key " + std::to_string(key));
      Rng rng(key);
      Triangulation t = delaunay(set.points);
      if (t.corner.empty()) continue;
      std::vector<VertexPair> segments;
      for (int i = 0; i < 4; ++i) {
        const VertexPair s{t.corner[rng.below(t.corner.size())], t.corner[rng.below(t.corner.size())]};
        if (s.first != s.second) segments.push_back(s);
      }
      const Triangulation before = t;
      const Constraints c = insert_segments(t, set.points, segments);
      expect_constrained(t, c, set.points, segments);
      crossing += c.crossing != kNoEdge;
      long_ones += t.corner != before.corner;
    }
  EXPECT_GT(crossing, 100u);
  EXPECT_GT(long_ones, 300u);
}

TEST(Constrained, TheInsideOfAPolygonWithAHole) {
  const std::vector<Point2> points{{0, 0}, {90, 0}, {90, 90}, {45, 20}, {0, 90}, {40, 5}, {40, 12}, {50, 12}, {50, 5}};
  Triangulation t = delaunay(points);
  const std::vector<VertexPair> segments{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {5, 6}, {6, 7}, {7, 8}, {8, 5}};
  const Constraints c = insert_segments(t, points, segments);
  expect_constrained(t, c, points, segments);
  const auto inside = triangles_inside(t, c, segments);
  const Polygons polygons = assemble_rings(boundary_edges(t, inside), points);
  EXPECT_EQ(polygons.vertices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(polygons.count, 1u);
}

}  // namespace
}  // namespace ilot
