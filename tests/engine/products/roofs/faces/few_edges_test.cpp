// SPDX-License-Identifier: Apache-2.0
// Joined planes, joined corners and planes that concur: what makes roofs of few straight edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/products/roofs/faces/concurrence.h"
#include "engine/products/roofs/faces/corner_joining.h"
#include "engine/products/roofs/faces/roof_planes.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::roof_site;

std::size_t planes_with(double detail, const std::function<double(double, double)>& height) {
  RoofModelParams params;
  params.detail = detail;
  return find_roof_planes(roof_site(16, 10, height), params).planes.size();
}

// Falls by 3 % to a gutter in the middle.
double drained(double x, double) {
  return 5 + 0.03 * std::abs(x - 8);
}

TEST(PlaneJoining, AFlatRoofThatIsDrainedIsOneFace) {
  EXPECT_EQ(planes_with(0.15, drained), 1u);
  EXPECT_GE(planes_with(0, drained), 2u);
}

TEST(PlaneJoining, AStepAndASlopeStay) {
  EXPECT_EQ(planes_with(0.15, [](double x, double) { return x < 8 ? 5 : 5.5; }), 2u);
  EXPECT_EQ(planes_with(0.15, [](double x, double) { return 5 + 0.2 * std::min(x, 16 - x); }), 2u);
}

TEST(PlaneJoining, EveryPointOfAJoinedPlaneIsWithinEpsilonOfIt) {
  const RoofSite site = roof_site(16, 10, drained);
  const RoofPlanes planes = find_roof_planes(site, {});
  std::size_t off = 0;
  for (std::size_t i = 0; i < site.points.size(); ++i) {
    if (planes.of_point[i] == 0) continue;
    const Vec3 p = site.points[i];
    off += std::abs(p.z - planes.planes[planes.of_point[i] - 1].at(p.x, p.y)) > planes.epsilon;
  }
  EXPECT_LE(off, site.points.size() / 10);
}

// Four faces of a hipped roof whose ridge is broken in two pieces 8 cm beside each other.
Partition broken_hip() {
  Partition p;
  p.vertices = {{0, 0}, {0, 6000}, {3000, 3000}, {6000, 3000}, {6000, 3080}, {9000, 3040}, {12000, 0}, {12000, 6000}};
  p.regions = 4;
  const auto edge = [&](std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right) {
    p.edges.push_back({a, b, left, right});
  };
  edge(0, 6, 1, 0), edge(6, 7, 2, 0), edge(7, 1, 3, 0), edge(1, 0, 4, 0);  // south, east, north, west
  edge(0, 2, 4, 1), edge(2, 1, 4, 3), edge(2, 3, 3, 1), edge(3, 4, 3, 1), edge(4, 5, 3, 1);
  edge(5, 6, 2, 1), edge(7, 5, 2, 3);
  tidy(p);
  return p;
}

std::vector<RoofPlane> hip_planes() {
  std::vector<RoofPlane> planes(4);
  planes[0].gy = 1, planes[0].c = 4;
  planes[1].gx = -1, planes[1].c = 16.03;
  planes[2].gy = -1, planes[2].c = 10.05;
  planes[3].gx = 1, planes[3].c = 4;
  return planes;
}

const SitePolygon kOutline{{{0, 0}, {12000, 0}, {12000, 6000}, {0, 6000}}};

TEST(CornerJoining, AShortEdgeBecomesACorner) {
  Partition p = broken_hip();
  const std::size_t before = p.vertices.size();
  join_corners(p, kOutline, hip_planes(), 0.15);
  EXPECT_EQ(p.vertices.size(), before - 1);
  for (const PartitionEdge& e : p.edges) EXPECT_GT(squared_distance(p.vertices[e.from], p.vertices[e.to]), 150 * 150);
  for (const Point2 corner : kOutline[0])
    EXPECT_NE(std::find(p.vertices.begin(), p.vertices.end(), corner), p.vertices.end());
  const std::vector<double> areas = region_areas(p);
  for (std::size_t r = 1; r < areas.size(); ++r) EXPECT_GT(areas[r], 8) << r;
  EXPECT_NEAR(areas[1] + areas[2] + areas[3] + areas[4], 72, 1e-9);
}

TEST(CornerJoining, ThreeFacesMeetWhereTheirHeightsAgree) {
  Partition p = broken_hip();
  std::vector<RoofPlane> planes = hip_planes();
  planes[2].c = 10;
  planes[1].c = 16;
  // The ends of a short edge beside the eastern peak (9, 3), of which both are off.
  for (Point2& v : p.vertices)
    if (v == Point2{6000, 3080}) v = {8950, 3080};
  tidy(p);
  join_corners(p, kOutline, planes, 0.15);
  const auto peak =
      std::find_if(p.vertices.begin(), p.vertices.end(), [](Point2 v) { return v.x > 8800 && v.x < 9200; });
  ASSERT_NE(peak, p.vertices.end());
  EXPECT_NEAR(peak->x, 9000, 5);
  EXPECT_NEAR(peak->y, 3000, 5);
}

TEST(Concurrence, PlanesMeetInTheirCorners) {
  Partition p = broken_hip();
  std::vector<RoofPlane> planes = hip_planes();
  join_corners(p, kOutline, planes, 0.15);
  straighten_borders(p, kOutline, 0.15);
  const RoofSite site = roof_site(12, 6, [](double x, double y) { return 4 + std::min({x, 12 - x, y, 6 - y}); });
  std::vector<FlatPoint> flat;
  for (const Vec3& v : site.points) flat.push_back({v.x * 1000, v.y * 1000});
  adjust_to_concur(p, site.points, regions_of(p, flat), 0.15, planes);
  for (std::uint32_t v = 0; v < p.vertices.size(); ++v) {
    std::set<std::uint32_t> around;
    for (const PartitionEdge& e : p.edges)
      if (e.from == v || e.to == v) around.insert({e.left, e.right});
    around.erase(kOutside);
    double low = 1e9, high = -1e9;
    for (const std::uint32_t f : around) {
      const double z = planes[f - 1].at(p.vertices[v].x / 1000.0, p.vertices[v].y / 1000.0);
      low = std::min(low, z);
      high = std::max(high, z);
    }
    EXPECT_LT(high - low, 0.001) << p.vertices[v].x << ' ' << p.vertices[v].y;
  }
  for (const Vec3& point : site.points) {
    const std::uint32_t f = regions_of(p, std::vector<FlatPoint>{{point.x * 1000, point.y * 1000}})[0];
    if (f != kOutside) {
      EXPECT_LT(std::abs(planes[f - 1].at(point.x, point.y) - point.z), 0.2);
    }
  }
}

TEST(Concurrence, AStepStaysAStep) {
  Partition p;
  p.vertices = {{0, 0}, {0, 6000}, {5000, 0}, {5000, 6000}, {12000, 0}, {12000, 6000}};
  p.regions = 2;
  p.edges = {{0, 2, 1, 0}, {2, 4, 2, 0}, {4, 5, 2, 0}, {5, 3, 2, 0}, {3, 1, 1, 0}, {1, 0, 1, 0}, {2, 3, 1, 2}};
  tidy(p);
  std::vector<RoofPlane> planes(2);
  planes[0].c = 8;
  planes[1].c = 4;
  const RoofSite site = roof_site(12, 6, [](double x, double) { return x < 5 ? 8.0 : 4.0; });
  std::vector<FlatPoint> flat;
  for (const Vec3& v : site.points) flat.push_back({v.x * 1000, v.y * 1000});
  adjust_to_concur(p, site.points, regions_of(p, flat), 0.15, planes);
  EXPECT_EQ(planes[0].c, 8);
  EXPECT_EQ(planes[1].c, 4);
}

}  // namespace
}  // namespace ilot
