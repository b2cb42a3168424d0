// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/line_net.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Segments = std::vector<NetSegment>;

std::vector<std::pair<Point2, Point2>> edges_of(const LineNet& net) {
  std::vector<std::pair<Point2, Point2>> edges;
  for (const NetEdge& e : net.edges) edges.emplace_back(net.vertices[e.from], net.vertices[e.to]);
  return edges;
}

int side(Point2 a, Point2 b, Point2 p) {
  const std::int64_t twice = orient2d(a, b, p);
  return twice > 0 ? 1 : twice < 0 ? -1 : 0;
}

// Edges have no vertex between their ends and do not cross.
void expect_noded(const LineNet& net) {
  for (std::size_t v = 1; v < net.vertices.size(); ++v) ASSERT_LT(net.vertices[v - 1], net.vertices[v]);
  const auto edges = edges_of(net);
  for (const auto& [a, b] : edges) {
    ASSERT_LT(a, b);
    for (const Point2 v : net.vertices)
      ASSERT_FALSE(a < v && v < b && side(a, b, v) == 0) << a.x << " " << a.y << ", " << b.x << " " << b.y;
    for (const auto& [c, d] : edges)
      ASSERT_FALSE(side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0);
  }
}

double distance(Point2 p, const NetSegment& s) {
  const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y, x = p.x - s.a.x, y = p.y - s.a.y;
  const double t = std::clamp((x * dx + y * dy) / std::max(dx * dx + dy * dy, 1.0), 0.0, 1.0);
  return std::hypot(x - t * dx, y - t * dy);
}

Segments random_segments(Rng& rng, std::uint32_t range, std::size_t count) {
  const auto at = [&] { return static_cast<std::int32_t>(rng.below(range)) - static_cast<std::int32_t>(range / 2); };
  Segments segments;
  for (std::size_t i = 0; i < count; ++i) segments.push_back({{at(), at()}, {at(), at()}, rng.below(2) == 0});
  return segments;
}

TEST(LineNet, TwoThatCrossMeetInTheRoundedPoint) {
  const LineNet net = snap_rounded(Segments{{{0, 0}, {10, 5}, true}, {{0, 5}, {10, 0}, false}});
  EXPECT_EQ(net.vertices, (std::vector<Point2>{{0, 0}, {0, 5}, {5, 3}, {10, 0}, {10, 5}}));  // 2.5: up
  ASSERT_EQ(net.edges.size(), 4u);
  EXPECT_TRUE(net.edges[0].border);
  EXPECT_FALSE(net.edges[1].border);
}

TEST(LineNet, TwiceTheBorderIsNone) {
  const Segments twice{{{0, 0}, {10, 0}, true}, {{20, 0}, {0, 0}, true}};
  const LineNet net = snap_rounded(twice);
  ASSERT_EQ(net.edges.size(), 2u);
  EXPECT_FALSE(net.edges[0].border);
  EXPECT_TRUE(net.edges[1].border);
}

TEST(LineNet, ASegmentGoesThroughVerticesWithinHalfAUnit) {
  // At x = 3 the line is at 0.375.
  const auto bends = [](Point2 v) {
    const LineNet net =
        snap_rounded(Segments{{{0, 0}, {8, 1}, false}, {v, {v.x, 100}, false}, {v, {v.x, -100}, false}});
    return std::any_of(net.edges.begin(), net.edges.end(), [&](const NetEdge& e) {
      return net.vertices[e.from] == Point2{0, 0} && net.vertices[e.to] == v;
    });
  };
  EXPECT_TRUE(bends({3, 0}));
  EXPECT_FALSE(bends({3, 1}));
}

TEST(LineNet, RandomSegmentsAreNodedAndStayWhereTheyWere) {
  Rng rng(5);
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t range = std::uint32_t{8} << rng.below(12);
    const Segments segments = random_segments(rng, range, 1 + rng.below(14));
    const LineNet net = snap_rounded(segments);
    expect_noded(net);
    for (const auto& [a, b] : edges_of(net)) {
      const bool near = std::any_of(segments.begin(), segments.end(), [&, a = a, b = b](const NetSegment& s) {
        return distance(a, s) <= std::sqrt(0.5) && distance(b, s) <= std::sqrt(0.5);
      });
      EXPECT_TRUE(near);
    }
  }
}

TEST(LineNet, FarFromTheOriginAndLongNothingOverflows) {
  Rng rng(9);
  for (int round = 0; round < 20; ++round)
    expect_noded(snap_rounded(random_segments(rng, 2 * static_cast<std::uint32_t>(kMaxPlaneCoordinate), 8)));
}

TEST(LineNet, IsAPropertyOfTheSet) {
  Rng rng(6);
  for (int round = 0; round < 50; ++round) {
    Segments segments = random_segments(rng, 60, 10);
    const LineNet net = snap_rounded(segments);
    std::reverse(segments.begin(), segments.end());
    for (NetSegment& s : segments) std::swap(s.a, s.b);
    const LineNet other = snap_rounded(segments);
    EXPECT_EQ(net.vertices, other.vertices);
    EXPECT_EQ(edges_of(net), edges_of(other));
  }
}

TEST(LineNet, NothingAndPointsGiveNothing) {
  EXPECT_TRUE(snap_rounded({}).vertices.empty());
  EXPECT_TRUE(snap_rounded(Segments{{{3, 4}, {3, 4}, true}}).edges.empty());
}

}  // namespace
}  // namespace ilot
