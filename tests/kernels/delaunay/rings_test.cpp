// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/rings.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "kernels/delaunay/alpha_shape.h"
#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

// Unit squares of a lattice, each cut into two triangles: pictures of characters, a letter is a label.
struct Picture {
  std::vector<Point2> points;
  Triangulation t;
  std::vector<std::uint8_t> label;
};

Picture picture(const std::vector<std::string>& rows) {
  Picture p;
  const auto height = static_cast<std::int32_t>(rows.size()), width = static_cast<std::int32_t>(rows[0].size());
  for (std::int32_t y = 0; y <= height; ++y)
    for (std::int32_t x = 0; x <= width; ++x) p.points.push_back({x, y});
  p.t = delaunay(p.points);
  for (std::size_t i = 0; i < p.t.triangles(); ++i) {
    std::int32_t x = width, y = height;
    for (std::size_t k = 0; k < 3; ++k) {
      x = std::min(x, p.points[p.t.corner[3 * i + k]].x);
      y = std::min(y, p.points[p.t.corner[3 * i + k]].y);
    }
    const char c = rows[static_cast<std::size_t>(height - 1 - y)][static_cast<std::size_t>(x)];
    p.label.push_back(c == '.' ? 0 : static_cast<std::uint8_t>(c));
  }
  return p;
}

// Edges in rings exactly once, no vertex twice in a ring, one outer ring first, areas as signed, canonical starts.
void expect_sound(const Polygons& polygons, std::vector<BoundaryEdge> edges, const std::vector<Point2>& points) {
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> given, found;
  for (const BoundaryEdge& e : edges) given.insert({e.from, e.to});
  std::uint32_t polygon = 0;
  bool first = true;
  for (const Ring& ring : polygons.rings) {
    if (ring.polygon != polygon) first = true;
    polygon = ring.polygon;
    const auto* v = &polygons.vertices[ring.first];
    ASSERT_GE(ring.count, 3u);
    EXPECT_EQ(std::set<std::uint32_t>(v, v + ring.count).size(), ring.count);
    for (std::uint32_t i = 0; i < ring.count; ++i) {
      found.insert({v[i], v[(i + 1) % ring.count]});
      EXPECT_LE(points[v[0]], points[v[i]]);
    }
    EXPECT_EQ(twice_area(polygons, ring, points) > 0, first);
    first = false;
  }
  EXPECT_EQ(given, found);
}

Polygons rings_of(const Picture& p) {
  const auto edges = boundary_edges(p.t, p.label);
  Polygons polygons = assemble_rings(edges, p.points);
  expect_sound(polygons, edges, p.points);
  return polygons;
}

// Rings per polygon.
std::vector<int> ring_counts(const Polygons& polygons) {
  std::vector<int> n(polygons.count);
  for (const Ring& r : polygons.rings) ++n[r.polygon];
  return n;
}

TEST(Rings, OneSquare) {
  const Picture p = picture({"x"});
  const Polygons polygons = rings_of(p);
  EXPECT_EQ(polygons.vertices, (std::vector<std::uint32_t>{0, 1, 3, 2}));
  EXPECT_EQ(polygons.rings, (std::vector<Ring>{{0, 4, 0}}));
}

TEST(Rings, HolesBelongToTheirPolygonAndIslandsDoNot) {
  const Picture p = picture({"xxxxxxx", "x.....x", "x.xxx.x", "x.x.x.x", "x.xxx.x", "x.....x", "xxxxxxx"});
  EXPECT_EQ(ring_counts(rings_of(p)), (std::vector<int>{2, 2}));
}

TEST(Rings, SquaresThatTouchInACornerArePolygonsOfTheirOwn) {
  EXPECT_EQ(ring_counts(rings_of(picture({"x.", ".x"}))), (std::vector<int>{1, 1}));
  EXPECT_EQ(ring_counts(rings_of(picture({"x.x", ".x.", "x.x"}))), (std::vector<int>{1, 1, 1, 1, 1}));
}

TEST(Rings, HolesThatTouchEachOtherOrTheOutsideAreCutOff) {
  EXPECT_EQ(ring_counts(rings_of(picture({"xxxx", "x.xx", "xx.x", "xxxx"}))), (std::vector<int>{3}));
  EXPECT_EQ(ring_counts(rings_of(picture({"xxx.", "x.xx", "xxxx"}))), (std::vector<int>{2}));
  // The outer ring pinched off in a corner: what it encloses is a hole.
  EXPECT_EQ(ring_counts(rings_of(picture({"xxxx", "x..x", "x..x", "xx..", "xxx."}))), (std::vector<int>{1}));
  EXPECT_EQ(ring_counts(rings_of(picture({"xxxx", "x..x", "x.xx", "xx..", "xxxx"}))), (std::vector<int>{2}));
}

TEST(Rings, LabelsAreRegionsOfTheirOwn) {
  EXPECT_EQ(ring_counts(rings_of(picture({"aaaa", "abba", "abca", "aaaa"}))), (std::vector<int>{2, 1, 1}));
  EXPECT_EQ(ring_counts(rings_of(picture({"ab", "ba"}))), (std::vector<int>{1, 1, 1, 1}));
}

// Any set of triangles of any triangulation, also from their corners alone and in any order.
TEST(Rings, AnySetOfTriangles) {
  Rng rng(8);
  for (int round = 0; round < 300; ++round)
    for (const auto& set : test::plane_sets(40, static_cast<std::uint64_t>(round))) {
      SCOPED_TRACE(set.name + ", round " + std::to_string(round));
      const Triangulation t = delaunay(set.points);
      std::vector<std::uint8_t> keep(t.triangles());
      const std::uint64_t share = 1 + rng.below(9);
      std::vector<std::uint32_t> corner;
      std::int64_t area = 0;
      for (std::size_t i = 0; i < keep.size(); ++i) {
        keep[i] = rng.below(10) < share;
        if (!keep[i]) continue;
        const std::uint32_t v[]{t.corner[3 * i], t.corner[3 * i + 1], t.corner[3 * i + 2]};
        corner.insert(rng.below(2) ? corner.end() : corner.begin(), v, v + 3);
        area += orient2d(set.points[v[0]], set.points[v[1]], set.points[v[2]]);
      }
      const auto edges = boundary_edges(t, keep);
      const Polygons polygons = assemble_rings(edges, set.points);
      expect_sound(polygons, edges, set.points);
      for (const Ring& r : polygons.rings) area -= twice_area(polygons, r, set.points);
      EXPECT_EQ(area, 0);
      const Polygons again = assemble_rings(boundary_edges(corner), set.points);
      EXPECT_EQ(again.vertices, polygons.vertices);
      EXPECT_EQ(again.rings, polygons.rings);
    }
}

// A lattice of squares with a hole and an island in it, another part beside it, and a window in that.
TEST(OuterRings, LeaveOutHolesAndWhatLiesInThem) {
  std::vector<Point2> points;
  for (std::int32_t x = 0; x < 24; ++x)
    for (std::int32_t y = 0; y < 12; ++y) {
      const bool hole = x > 2 && x < 9 && y > 2 && y < 9 && !(x >= 5 && x <= 6 && y >= 5 && y <= 6);
      const bool gap = x > 12 && x < 16;
      const bool window = x > 18 && x < 21 && y > 4 && y < 7;
      if (!hole && !gap && !window) points.push_back({10 * x, 10 * y});
    }
  const Triangulation t = delaunay(points);
  const std::vector<float> reach(points.size(), 7.2f);
  const auto keep = shape_triangles(t, points, {TriangleRule::kCircumradius, reach});
  const Polygons all = assemble_rings(boundary_edges(t, keep), points);
  ASSERT_EQ(all.count, 3u);
  ASSERT_EQ(all.rings.size(), 5u);
  const Polygons outer = outer_rings(all, points);
  EXPECT_EQ(outer.count, 2u);
  ASSERT_EQ(outer.rings.size(), 2u);
  EXPECT_EQ(twice_area(outer, outer.rings[0], points), 2 * 120 * 110);
  EXPECT_EQ(twice_area(outer, outer.rings[1], points), 2 * 70 * 110);
  EXPECT_EQ(outer.rings[1].polygon, 1u);
}

bool ring_contains(const Polygons& polygons, const Ring& r, std::span<const Point2> points, double x, double y) {
  bool inside = false;
  for (std::uint32_t i = 0; i < r.count; ++i) {
    const Point2 a = points[polygons.vertices[r.first + i]], b = points[polygons.vertices[r.first + (i + 1) % r.count]];
    if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

TEST(OuterRings, HoldEveryTriangleOnceAndOnlyWholeOnes) {
  Rng rng(21);
  for (int round = 0; round < 20; ++round) {
    std::vector<Point2> points;
    for (int i = 0; i < 500; ++i) points.push_back({test::draw_within(rng, 400), test::draw_within(rng, 400)});
    const Triangulation t = delaunay(points);
    const std::vector<float> reach(points.size(), static_cast<float>(16 + rng.below(20)));
    const auto keep = shape_triangles(t, points, {TriangleRule::kCircumradius, reach});
    const Polygons all = assemble_rings(boundary_edges(t, keep), points), outer = outer_rings(all, points);
    EXPECT_LE(outer.rings.size(), all.rings.size());
    std::int64_t held = 0, bounded = 0;
    for (std::size_t i = 0; i < keep.size(); ++i) {
      const Point2 a = points[t.corner[3 * i]], b = points[t.corner[3 * i + 1]], c = points[t.corner[3 * i + 2]];
      const double x = (a.x + b.x + c.x) / 3.0, y = (a.y + b.y + c.y) / 3.0;
      const auto holders = std::count_if(outer.rings.begin(), outer.rings.end(),
                                         [&](const Ring& r) { return ring_contains(outer, r, points, x, y); });
      EXPECT_LE(holders, 1);
      EXPECT_TRUE(!keep[i] || holders == 1);
      if (holders > 0) held += orient2d(a, b, c);
    }
    for (const Ring& r : outer.rings) bounded += twice_area(outer, r, points);
    EXPECT_EQ(bounded, held);
  }
}

}  // namespace
}  // namespace ilot
