// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/partition.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "kernels/core/rng.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::rectangle;

// Every vertex at its own place, edges from the smaller to the larger, sorted, no edge twice, none between one region.
void expect_in_order(const Partition& p) {
  for (std::size_t v = 1; v < p.vertices.size(); ++v) EXPECT_LT(p.vertices[v - 1], p.vertices[v]);
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (const PartitionEdge& e : p.edges) {
    EXPECT_LT(e.from, e.to);
    EXPECT_NE(e.left, e.right);
    EXPECT_LE(std::max(e.left, e.right), p.regions);
    EXPECT_TRUE(seen.insert({e.from, e.to}).second);
  }
}

double total_area(const Partition& p) {
  const std::vector<double> areas = region_areas(p);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

TEST(Partition, WithoutLinesThePolygonItself) {
  const Partition p = part(rectangle(10, 6), {});
  EXPECT_EQ(p.regions, 1u);
  EXPECT_EQ(p.vertices.size(), 4u);
  EXPECT_EQ(p.edges.size(), 4u);
  EXPECT_DOUBLE_EQ(region_areas(p)[1], 60);
}

TEST(Partition, ALineAcrossMakesTwo) {
  const Partition p = part(rectangle(10, 6), std::vector<FlatEdge>{{{4, -1}, {4, 7}}});
  expect_in_order(p);
  ASSERT_EQ(p.regions, 2u);
  EXPECT_DOUBLE_EQ(region_areas(p)[1], 24);
  EXPECT_DOUBLE_EQ(region_areas(p)[2], 36);
}

TEST(Partition, LinesThatLeadNowhereAreDropped) {
  EXPECT_EQ(part(rectangle(10, 6), std::vector<FlatEdge>{{{4, 2}, {4, 7}}, {{20, 0}, {20, 5}}}).regions, 1u);
}

TEST(Partition, KeepsHolesOut) {
  SitePolygon courtyard = rectangle(10, 10);
  courtyard.push_back({{3000, 3000}, {3000, 7000}, {7000, 7000}, {7000, 3000}});
  EXPECT_DOUBLE_EQ(total_area(part(courtyard, {})), 84);
  const Partition p = part(courtyard, std::vector<FlatEdge>{{{5, -1}, {5, 11}}});
  EXPECT_EQ(p.regions, 2u);
  EXPECT_DOUBLE_EQ(total_area(p), 84);
  EXPECT_EQ(regions_of(p, std::vector<FlatPoint>{{5000, 5000}})[0], kOutside);
}

// Areas fill the polygon, and points are in the region whose winding number around them is not 0.
TEST(Partition, RandomLinesFillThePolygon) {
  Rng rng(3);
  for (int round = 0; round < 60; ++round) {
    std::vector<FlatEdge> lines;
    for (std::uint64_t i = 1 + rng.below(25); i-- > 0;)
      lines.push_back(
          {{14 * rng.uniform() - 2, 10 * rng.uniform() - 2}, {14 * rng.uniform() - 2, 10 * rng.uniform() - 2}});
    const Partition p = part(rectangle(10, 6), lines);
    expect_in_order(p);
    ASSERT_NEAR(total_area(p), 60, 0.05);
    std::vector<FlatPoint> points;
    for (int i = 0; i < 50; ++i) points.push_back({12000 * rng.uniform() - 1000, 8000 * rng.uniform() - 1000});
    const std::vector<std::uint32_t> regions = regions_of(p, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<int> crossings(p.regions + 1, 0);
      for (const PartitionEdge& e : p.edges) {
        const Point2 a = p.vertices[e.from], b = p.vertices[e.to];
        if ((a.x > points[i].x) == (b.x > points[i].x)) continue;
        const double y = a.y + (points[i].x - a.x) / static_cast<double>(b.x - a.x) * (b.y - a.y);
        if (y > points[i].y) continue;
        ++crossings[e.left];
        ++crossings[e.right];
      }
      for (std::uint32_t r = 1; r <= p.regions; ++r) ASSERT_EQ(crossings[r] % 2 == 1, regions[i] == r);
    }
  }
}

TEST(Partition, MergingAllGivesThePolygonBack) {
  const std::vector<FlatEdge> lines{{{4, -1}, {4.1, 7}}, {{-1, 2}, {11, 3.3}}, {{1, -1}, {9, 7}}};
  const Partition cells = part(rectangle(10, 6), lines);
  ASSERT_GT(cells.regions, 4u);
  const std::vector<std::uint32_t> label(cells.regions, 1);
  const Partition one = merged(cells, label, 1, std::vector<std::uint8_t>(cells.vertices.size(), 0));
  expect_in_order(one);
  EXPECT_EQ(one.vertices.size(), 4u);
  EXPECT_DOUBLE_EQ(region_areas(one)[1], 60);
}

TEST(Partition, FixedVerticesStay) {
  const Partition cells = part(rectangle(10, 6), std::vector<FlatEdge>{{{4, -1}, {4, 7}}});
  const std::vector<std::uint32_t> label{1, 1};
  const Partition one = merged(cells, label, 1, std::vector<std::uint8_t>(cells.vertices.size(), 1));
  EXPECT_EQ(one.vertices.size(), 6u);
}

TEST(Partition, TidyDropsARegionThatHasLostItsWidth) {
  // A triangle between two regions whose third corner falls onto the second.
  Partition p{{{0, 0}, {0, 10}, {5, 10}, {5, 10}, {10, 0}}, {}, 3};
  p.edges = {{0, 1, kOutside, 1}, {1, 2, kOutside, 1}, {0, 2, 1, 2},       {2, 3, kOutside, 2},
             {0, 3, 2, 3},        {3, 4, kOutside, 3}, {0, 4, 3, kOutside}};
  tidy(p);
  ASSERT_EQ(p.vertices.size(), 4u);
  EXPECT_EQ(p.edges.size(), 5u);
  for (const PartitionEdge& e : p.edges) {
    EXPECT_NE(e.left, 2u);
    EXPECT_NE(e.right, 2u);
  }
}

TEST(Partition, EdgesPassThroughVerticesTheyNearlyTouch) {
  // Two regions whose border runs a millimetre beside a corner of the outline: no spike may be left there.
  const SitePolygon outline{{{0, 0}, {10000, 0}, {10000, 6000}, {5000, 6000}, {5000, 6001}, {0, 6001}}};
  Partition p = part(outline, std::vector<FlatEdge>{{{5.001, -1}, {5.001, 7}}});
  close_short_edges(p, outline, 0.003);
  expect_in_order(p);
  ASSERT_EQ(p.regions, 2u);
  EXPECT_NEAR(total_area(p), 60.005, 0.01);
  for (const PartitionEdge& e : p.edges) {
    if (e.left == kOutside || e.right == kOutside) continue;
    EXPECT_TRUE(p.vertices[e.to] == (Point2{5000, 6000}) || p.vertices[e.from] == (Point2{5000, 6000}));
  }
}

TEST(Partition, RegionsComeBackAsPolygons) {
  SitePolygon courtyard = rectangle(10, 10);
  courtyard.push_back({{3000, 3000}, {3000, 7000}, {7000, 7000}, {7000, 3000}});
  EXPECT_EQ(region_polygons(part(courtyard, {})), (std::vector<SitePolygon>{courtyard}));
  const auto halves = region_polygons(part(courtyard, std::vector<FlatEdge>{{{5, -1}, {5, 11}}}));
  ASSERT_EQ(halves.size(), 2u);
  for (const SitePolygon& half : halves) {
    ASSERT_EQ(half.size(), 1u);
    EXPECT_EQ(half[0].size(), 8u);
  }
}

}  // namespace
}  // namespace ilot
