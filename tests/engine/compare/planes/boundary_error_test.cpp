// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/planes/boundary_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/compare/planes/plane_frame.h"

namespace ilot {
namespace {

// A wall of 10 x 10 m with a window of 4 x 4 m in its midst, made of two polygons that meet along x = 3 below it.
TruePlane wall_with_window() {
  const auto p = [](double x, double z) { return Vec3{651000 + x, 6861000, z}; };
  TruePlane wall{1, "wall", {{0, -1, 0}, 6861000}, {}};
  wall.polygons.push_back({0, {p(0, 0), p(3, 0), p(3, 10), p(0, 10)}, {}});
  wall.polygons.push_back({0, {p(3, 0), p(10, 0), p(10, 10), p(3, 10)}, {{p(3, 3), p(7, 3), p(7, 7), p(3, 7)}}});
  return wall;
}

// Points every half metre, a quarter from the edges; `marked` says which are found to be boundary.
template <class Marked>
BoundaryPoints scan(Marked marked) {
  BoundaryPoints points;
  for (double x = 0.25; x < 10; x += 0.5)
    for (double z = 0.25; z < 10; z += 0.5) {
      if (x > 3 && x < 7 && z > 3 && z < 7) continue;
      points.own.push_back({651000 + x, 6861000 + 0.003 * std::sin(x), z});
      points.true_point.push_back(1);
      points.marked.push_back(marked(x, z));
    }
  return points;
}

bool beside_edge(double x, double z) {
  const bool outer = x < 0.5 || x > 9.5 || z < 0.5 || z > 9.5;
  return outer || (x > 2.5 && x < 7.5 && z > 2.5 && z < 7.5);
}

// Where the two polygons meet is no edge: what there is lies on a side of the wall or of the window, and covers them.
TEST(BoundaryError, TheEdgesAreTheOutlineOfTheUnion) {
  const TruePlane wall = wall_with_window();
  const FlatFrame frame = plane_frame(wall.plane.n, wall.polygons[0].ring[0]);
  const auto corner = [&](double x, double z) { return frame.flat({651000 + x, 6861000, z}); };
  std::vector<FlatEdge> sides;
  for (const auto& [low, high] : {std::pair{0.0, 10.0}, std::pair{3.0, 7.0}}) {
    const FlatPoint corners[]{corner(low, low), corner(high, low), corner(high, high), corner(low, high)};
    for (std::size_t i = 0; i < 4; ++i) sides.push_back({corners[i], corners[(i + 1) % 4]});
  }
  constexpr double kNear = 1e-9;  // corners are whole millimetres; doubles at 651,000 m lie 1.2e-10 m apart
  double length = 0;
  for (const FlatEdge& edge : true_edges(wall)) {
    const auto holds = [](const FlatEdge& side, FlatPoint p) {
      const FlatPoint along = side.b - side.a, to = p - side.a;
      const double size = std::sqrt(dot(along, along)), at = dot(to, along) / size;
      return std::abs(cross(along, to)) / size < kNear && at > -kNear && at < size + kNear;
    };
    EXPECT_TRUE(std::any_of(sides.begin(), sides.end(),
                            [&](const FlatEdge& side) { return holds(side, edge.a) && holds(side, edge.b); }))
        << edge.a.x << " " << edge.a.y << " to " << edge.b.x << " " << edge.b.y;
    const FlatPoint along = edge.b - edge.a;
    length += std::sqrt(dot(along, along));
  }
  EXPECT_NEAR(length, 4 * 10 + 4 * 4, 20 * kNear);
}

TEST(BoundaryError, IsZeroForTheRightPoints) {
  const TruePlane wall = wall_with_window();
  // Beside the window's corners stands a point whose cell touches the edge in the corner alone.
  const auto at_corner = [](double x, double z) {
    return std::min(std::abs(x - 2.75), std::abs(x - 7.25)) < 0.01 &&
           std::min(std::abs(z - 2.75), std::abs(z - 7.25)) < 0.01;
  };
  const BoundaryCounts counts =
      boundary_counts(wall, scan([&](double x, double z) { return beside_edge(x, z) && !at_corner(x, z); }));
  EXPECT_EQ(counts.truth, 4u * 19 + 4u * 8);
  EXPECT_EQ(counts.common, counts.truth);
  EXPECT_EQ(counts.error(), 0);
}

TEST(BoundaryError, CountsWhatIsMissedAndInvented) {
  const TruePlane wall = wall_with_window();
  // The outer edge alone, and a column in the midst of the wall; a stranger's point marked as well.
  BoundaryPoints points =
      scan([](double x, double z) { return x < 0.5 || x > 9.5 || z < 0.5 || z > 9.5 || (x > 1 && x < 1.5); });
  points.own.push_back({651005, 6861000, 5});
  points.true_point.push_back(0);
  points.marked.push_back(1);
  const BoundaryCounts counts = boundary_counts(wall, points);
  EXPECT_EQ(counts.truth, 108u);
  EXPECT_EQ(counts.common, 76u);
  EXPECT_EQ(counts.found, 76u + 18 + 1);
  EXPECT_DOUBLE_EQ(counts.error(), (32.0 + 19) / 76);
}

TEST(BoundaryError, OfNothing) {
  EXPECT_EQ(BoundaryCounts{}.error(), 0);
  EXPECT_TRUE(std::isinf((BoundaryCounts{5, 0, 0}).error()));
  EXPECT_EQ(boundary_counts({1, "", {}, {}}, scan(beside_edge)).truth, 0u);
  EXPECT_EQ(boundary_counts(wall_with_window(), {}).truth, 0u);
}

TEST(BoundaryError, MeasuresRings) {
  const std::vector<FlatPoint> inner{{1, 1}, {9, 1}, {9, 9}, {1, 9}};
  const std::vector<FlatEdge> square{{{0, 0}, {10, 0}}, {{10, 0}, {10, 10}}, {{10, 10}, {0, 10}}, {{0, 10}, {0, 0}}};
  EXPECT_NEAR(mean_ring_distance(inner, square, 0.01), 1, 1e-12);
  EXPECT_EQ(mean_ring_distance(inner, {}, 0.01), 0);
  const std::vector<FlatPoint> still{{3, 4}, {3, 4}, {3, 4}};
  EXPECT_NEAR(mean_ring_distance(still, square, 0.01), 3, 1e-12);
}

}  // namespace
}  // namespace ilot
