// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/thinning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "kernels/delaunay/alpha_shape.h"
#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

struct Shape {
  std::vector<Point2> points;
  Polygons polygons;
  std::size_t triangles = 0;
};

Shape thinned_shape(std::vector<Point2> points, float reach) {
  Shape s{std::move(points), {}, 0};
  const Triangulation t = delaunay(s.points);
  const auto keep = shape_triangles(t, s.points, {TriangleRule::kCircumradius, std::vector(s.points.size(), reach)});
  s.triangles = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 1));
  s.polygons = assemble_rings(boundary_edges(t, keep), s.points);
  return s;
}

double distance_to_ring(Point2 p, const Polygons& polygons, const Ring& ring, const std::vector<Point2>& points) {
  double best = 1e300;
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    const Point2 a = points[polygons.vertices[ring.first + i]],
                 b = points[polygons.vertices[ring.first + (i + 1) % ring.count]];
    const double x = b.x - a.x, y = b.y - a.y, u = p.x - a.x, v = p.y - a.y;
    const double s = std::clamp((x * u + y * v) / (x * x + y * y), 0.0, 1.0);
    best = std::min(best, std::hypot(u - s * x, v - s * y));
  }
  return best;
}

// No two edges of all rings share more than an end.
void expect_no_crossing(const Polygons& polygons, const std::vector<Point2>& points) {
  std::vector<std::pair<Point2, Point2>> edges;
  for (const Ring& ring : polygons.rings)
    for (std::uint32_t i = 0; i < ring.count; ++i)
      edges.emplace_back(points[polygons.vertices[ring.first + i]],
                         points[polygons.vertices[ring.first + (i + 1) % ring.count]]);
  const auto within = [](Point2 a, Point2 b, Point2 p) {
    return orient2d(a, b, p) == 0 && std::min(a, b) < p && p < std::max(a, b);
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto [a, b] = edges[i];
      const auto [c, d] = edges[j];
      const auto side = [](Point2 p, Point2 q, Point2 r) { return (orient2d(p, q, r) > 0) - (orient2d(p, q, r) < 0); };
      EXPECT_FALSE(side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0);
      EXPECT_FALSE(within(a, b, c) || within(a, b, d) || within(c, d, a) || within(c, d, b));
    }
}

void expect_thinned(const Shape& s, const Polygons& thin, double tolerance) {
  ASSERT_EQ(thin.rings.size(), s.polygons.rings.size());
  for (std::size_t r = 0; r < thin.rings.size(); ++r) {
    const Ring &before = s.polygons.rings[r], &after = thin.rings[r];
    EXPECT_EQ(twice_area(thin, after, s.points) > 0, twice_area(s.polygons, before, s.points) > 0);
    for (std::uint32_t i = 0; i < before.count; ++i)
      EXPECT_LT(distance_to_ring(s.points[s.polygons.vertices[before.first + i]], thin, after, s.points), tolerance);
  }
  expect_no_crossing(thin, s.points);
}

TEST(Thinning, VerticesOnEdgesGo) {
  std::vector<Point2> points;
  for (std::int32_t x = 0; x < 12; ++x)
    for (std::int32_t y = 0; y < 12; ++y)
      if (x < 4 || x > 7 || y < 4 || y > 7) points.push_back({100 * x, 100 * y});
  const Shape s = thinned_shape(points, 71);
  const Polygons thin = thin_rings(s.polygons, s.points, 1);
  EXPECT_EQ(thin.rings, (std::vector<Ring>{{0, 4, 0}, {4, 8, 0}}));  // the hole has cut corners
  expect_thinned(s, thin, 1);
  EXPECT_EQ(fill_polygons(thin, s.points).size() / 3, 12u);
}

TEST(Thinning, StaysWithinToleranceAndNeverCrosses) {
  Rng rng(2);
  for (int round = 0; round < 20; ++round) {
    std::vector<Point2> points;
    for (int i = 0; i < 600; ++i) points.push_back({test::draw_within(rng, 500), test::draw_within(rng, 500)});
    const Shape s = thinned_shape(points, 25 + static_cast<float>(round));
    for (const double tolerance : {1.0, 5.0, 60.0}) {
      SCOPED_TRACE("round " + std::to_string(round) + ", tolerance " + std::to_string(tolerance));
      const Polygons thin = thin_rings(s.polygons, s.points, tolerance);
      expect_thinned(s, thin, tolerance);
      const auto corner = fill_polygons(thin, s.points);
      std::int64_t area = 0;
      for (std::size_t i = 0; i < corner.size(); i += 3)
        area += orient2d(s.points[corner[i]], s.points[corner[i + 1]], s.points[corner[i + 2]]);
      for (const Ring& ring : thin.rings) area -= twice_area(thin, ring, s.points);
      EXPECT_EQ(area, 0);
      const std::size_t holes = thin.rings.size() - thin.count;
      std::set<std::pair<std::uint32_t, std::uint32_t>> distinct;
      for (const Ring& ring : thin.rings)
        for (std::uint32_t i = 0; i < ring.count; ++i) distinct.insert({ring.polygon, thin.vertices[ring.first + i]});
      const std::size_t touches = thin.vertices.size() - distinct.size();
      EXPECT_EQ(corner.size() / 3, thin.vertices.size() + 2 * holes - 2 * touches - 2 * thin.count);
    }
  }
}

// A facing stone of 60 x 50 cm scanned every 5 mm, coordinates in hundredths of a millimetre.
TEST(Thinning, AStoneLosesItsTriangles) {
  Rng rng(1);
  std::vector<Point2> points;
  for (std::int32_t x = 0; x <= 120; ++x)
    for (std::int32_t y = 0; y <= 100; ++y)
      points.push_back({500 * x + test::draw_within(rng, 60), 500 * y + test::draw_within(rng, 60)});
  const Shape s = thinned_shape(points, 800);
  const Polygons thin = thin_rings(s.polygons, s.points, 100);
  expect_thinned(s, thin, 100);
  const auto left = static_cast<double>(fill_polygons(thin, s.points).size() / 3);
  EXPECT_LT(left, 0.025 * static_cast<double>(s.triangles)) << s.triangles << " triangles before";
}

}  // namespace
}  // namespace ilot
