// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/face_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/products/roofs/solids/roof_model.h"
#include "engine/validity/validity.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::rectangle;
using test::roof_site;

// Falls by 0.5 per metre of x; its points lie between the heights 4 and 8.
RoofPlane falling_plane() {
  RoofPlane plane;
  plane.gx = -0.5;
  plane.c = 8;
  plane.lowest = 4;
  plane.highest = 8;
  return plane;
}

TEST(FaceLimits, AFaceMayFallToAStoreyBelowTheGroundOrAsFarAsItMayRise) {
  const FaceLimits limits{0.3, 0.5, 2};
  EXPECT_NEAR(too_high(falling_plane(), {-2, 0}, limits), 0.5, 1e-12);  // 9 m, may be 8.5
  EXPECT_NEAR(too_low(falling_plane(), {20, 0}, limits), 1, 1e-12);     // -2 m, and the ground is at 2
  EXPECT_LE(too_low(falling_plane(), {18, 0}, limits), 1e-12);
  // 2 m, and 3.5 would be left where the ground is above the points.
  EXPECT_NEAR(too_low(falling_plane(), {12, 0}, {0.3, 0.5, 8}), 1.5, 1e-12);
  EXPECT_NEAR(most_overshoot(falling_plane(), {2, 0.5, 0}), 3, 1e-12);  // three steps' rise
}

TEST(FaceLimits, TheEndOfThePointsIsLevelAndCrossesTheOutline) {
  RoofPlane plane = falling_plane();
  plane.gy = 0.25;
  const SitePolygon outline = rectangle(20, 10);
  const FlatEdge line = end_of_points(plane, outline);
  EXPECT_NEAR(plane.at(line.a.x, line.a.y), plane.lowest, 1e-9);
  EXPECT_NEAR(plane.at(line.b.x, line.b.y), plane.lowest, 1e-9);
  EXPECT_GE(norm(line.b - line.a), 2 * std::sqrt(500.0) - 1e-9);
}

TEST(FaceLimits, CellsThatFallBecomeLevelAtTheLowestPoint) {
  const FlatEdge cut{{8, -1}, {8, 11}};
  const Partition cells = part(rectangle(40, 10), std::vector<FlatEdge>{cut});
  ASSERT_EQ(cells.regions, 2u);
  RoofPlanes planes;
  planes.planes = {falling_plane()};
  const FaceLimits limits{0.3, 0.5, 0};
  std::vector<std::uint32_t> label{1, 1};
  EXPECT_EQ(falling_planes(planes, cells, label, limits), std::vector<std::uint32_t>{0});
  level_fallen(cells, limits, planes, label);
  ASSERT_EQ(planes.planes.size(), 2u);
  std::sort(label.begin(), label.end());
  EXPECT_EQ(label, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(planes.planes[1].at(30, 5), 4);
  EXPECT_TRUE(falling_planes(planes, cells, label, limits).empty());
}

// Points only in the first metres of a long outline, on one slope or on both sides of a ridge.
RoofSite cut_off(double seen, const std::function<double(double, double)>& height) {
  RoofSite site = roof_site(40, 10, height);
  std::erase_if(site.points, [&](const Vec3& p) { return p.x > seen; });
  return site;
}

TEST(FaceLimits, NoRoofFallsBelowTheGroundWhereTheCloudEnds) {
  const auto lean_to = [](double x, double) { return 9 - 0.6 * x; };
  const auto ridge = [](double x, double) { return 9 - 0.8 * std::abs(x - 4); };
  for (const RoofSite& site : {cut_off(8, lean_to), cut_off(8, ridge)}) {
    const RoofModel m = model_roof(site, {}, 1);
    ASSERT_EQ(m.status, RoofStatus::lod22);
    EXPECT_TRUE(validate_building(m.lod22, m.lod22.vertices.front(), 0.0001).empty());
    double lowest_point = 1e9, off = 0;
    for (const Vec3& p : site.points) lowest_point = std::min(lowest_point, p.z);
    for (std::size_t v = 0; v < m.map.faces.edges.size(); ++v)
      for (const std::uint32_t face : {m.map.faces.edges[v].left, m.map.faces.edges[v].right})
        if (face != kOutside)
          for (const std::uint32_t end : {m.map.faces.edges[v].from, m.map.faces.edges[v].to}) {
            const Point2 at = m.map.faces.vertices[end];
            EXPECT_GT(m.map.planes[face - 1].at(at.x / 1000.0, at.y / 1000.0), lowest_point - 1);
          }
    for (std::size_t i = 0; i < site.points.size(); ++i) off += m.face_of_point[i] == 0 ? 1 : 0;
    EXPECT_LT(off, 0.05 * static_cast<double>(site.points.size())) << "the slope keeps its points";
  }
}

}  // namespace
}  // namespace ilot
