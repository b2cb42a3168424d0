// SPDX-License-Identifier: Apache-2.0
#include "engine/flat_area.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

FlatPolygon rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

double length(const std::vector<FlatEdge>& edges) {
  double sum = 0;
  for (const auto& [a, b] : edges) sum += std::hypot(b.x - a.x, b.y - a.y);
  return sum;
}

TEST(FlatArea, MeasuresCommonAreas) {
  FlatPolygon framed = rectangle(0, 0, 10, 10);
  framed.holes.push_back(rectangle(2, 2, 8, 8).ring);
  const FlatArea frame(std::span(&framed, 1));
  const FlatPolygon right = rectangle(5, 0, 15, 10);
  EXPECT_NEAR(frame.area(), 64, 1e-12);
  EXPECT_NEAR(frame.common_area(FlatArea(std::span(&right, 1))), 32, 1e-12);
  EXPECT_NEAR(intersection_over_union(frame, FlatArea(std::span(&right, 1))), 32.0 / (64 + 100 - 32), 1e-12);
  EXPECT_NEAR(intersection_over_union(frame, frame), 1, 1e-12);
  EXPECT_NEAR(length(frame.edges()), 40 + 24, 1e-12);
}

TEST(FlatArea, HolesMayRunAlongTheOuterRing) {
  FlatPolygon notched = rectangle(3, 0, 10, 10);
  notched.holes.push_back(rectangle(3, 3, 7, 7).ring);
  EXPECT_NEAR(FlatArea(std::span(&notched, 1)).area(), 70 - 16, 1e-12);
}

TEST(FlatArea, NeighboursWithinTheGridBecomeOne) {
  const std::vector<FlatPolygon> halves{rectangle(0, 0, 5, 4), rectangle(5.0003, 0, 9, 4)};
  EXPECT_NEAR(length(FlatArea(halves, 0.001).edges()), 26, 0.01);
  EXPECT_NEAR(length(FlatArea(halves).edges()), 18 + 2 * 3.9997 + 8, 1e-9);
}

TEST(FlatArea, PartsDependOnTheAreaAlone) {
  const std::vector<FlatPolygon> some{rectangle(0, 0, 5, 4), rectangle(5, 0, 9, 4), rectangle(20, 0, 21, 1)};
  const std::vector<FlatPolygon> others{rectangle(20, 0, 21, 1), rectangle(3, 0, 9, 4), rectangle(0, 0, 4, 4)};
  const std::vector<FlatPolygon> a = FlatArea(some).simplified(0.01).polygons(),
                                 b = FlatArea(others).simplified(0.01).polygons();
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(a[i].ring.size(), 4u);
    EXPECT_GT(doubled_area(a[i].ring), 0);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(squared_distance(a[i].ring[k], b[i].ring[k]), 0);
  }
  FlatPolygon frame = rectangle(0, 0, 10, 10);
  frame.holes.push_back(rectangle(2, 2, 4, 4).ring);
  const std::vector<FlatPolygon> parts = FlatArea(std::span(&frame, 1)).polygons();
  ASSERT_EQ(parts.size(), 1u);
  ASSERT_EQ(parts[0].holes.size(), 1u);
  EXPECT_NEAR(doubled_area(parts[0].holes[0]), -8, 1e-12);
}

TEST(FlatArea, TakesWhatIsDegenerate) {
  const FlatArea none({});
  EXPECT_EQ(none.area(), 0);
  EXPECT_TRUE(none.edges().empty());
  EXPECT_EQ(intersection_over_union(none, none), 0);
  const FlatPolygon bow{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}, line{{{0, 0}, {1, 1}, {2, 2}}, {}},
      stump{{{0, 0}, {1, 0}}, {}};
  EXPECT_NEAR(FlatArea(std::span(&bow, 1)).area(), 2, 1e-12);
  EXPECT_EQ(FlatArea(std::span(&line, 1)).area(), 0);
  EXPECT_EQ(FlatArea(std::span(&stump, 1)).area(), 0);
}

}  // namespace
}  // namespace ilot
