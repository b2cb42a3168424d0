// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/roof_solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/validity/validity.h"
#include "kernels/core/rng.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::rectangle;

RoofPlane plane_of(double gx, double gy, double c) {
  RoofPlane p;
  p.gx = gx;
  p.gy = gy;
  p.c = c;
  return p;
}

// Every edge of every ring is used once each way.
bool closed(const RoofSolid& solid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> used;
  for (const BuildingSurface& s : solid.surfaces)
    for (const auto& ring : s.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) ++used[{ring[i], ring[(i + 1) % ring.size()]}];
  for (const auto& [edge, n] : used)
    if (n != 1 || used.count({edge.second, edge.first}) == 0) return false;
  return true;
}

std::vector<int> faults_of(const RoofSolid& solid) {
  Building b;
  b.id = "solid";
  b.vertices = solid.vertices;
  b.surfaces = solid.surfaces;
  return codes_of(validate_building(b, {}, 0.0001));
}

// Six times the volume's worth of every face seen from the origin: its divergence.
double volume(const RoofSolid& solid) {
  double sum = 0;
  for (const BuildingSurface& s : solid.surfaces)
    for (const auto& ring : s.rings)
      for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        sum += dot(solid.vertices[ring[0]], cross(solid.vertices[ring[i]], solid.vertices[ring[i + 1]]));
  return sum / 6;
}

TEST(RoofSolid, ABlock) {
  const RoofSolid s = extrude_roof(part(rectangle(10, 6), {}), std::vector<RoofPlane>{plane_of(0, 0, 5)}, 1);
  EXPECT_EQ(s.vertices.size(), 8u);
  EXPECT_EQ(s.surfaces.size(), 6u);
  EXPECT_TRUE(closed(s));
  EXPECT_NEAR(volume(s), 10 * 6 * 4, 1e-9);
  EXPECT_TRUE(faults_of(s).empty());
}

TEST(RoofSolid, AGableHasNoWallAtItsRidge) {
  const Partition p = part(rectangle(10, 6), std::vector<FlatEdge>{{{-1, 3}, {11, 3}}});
  const RoofSolid s = extrude_roof(p, std::vector<RoofPlane>{plane_of(0, 1, 3), plane_of(0, -1, 9)}, 0);
  EXPECT_EQ(s.surfaces.size(), 2 + 1 + 6u);  // the gable walls stand over two edges each
  EXPECT_TRUE(closed(s));
  EXPECT_NEAR(volume(s), 10 * 6 * 3 + 10 * 6 * 3 / 2.0, 1e-9);
  EXPECT_TRUE(faults_of(s).empty());
}

TEST(RoofSolid, FacesThatChangePlacesAlongABorderMeetInAVertex) {
  const Partition p = part(rectangle(10, 6), std::vector<FlatEdge>{{{-1, 3}, {11, 3}}});
  const RoofSolid s = extrude_roof(p, std::vector<RoofPlane>{plane_of(0, 0, 5), plane_of(0.4, 0, 3)}, 0);
  EXPECT_TRUE(closed(s));
  EXPECT_TRUE(faults_of(s).empty());
  EXPECT_NEAR(volume(s), 10 * 3 * 5 + 10 * 3 * 5, 1e-6);
}

TEST(RoofSolid, ACourtyardHasWalls) {
  SitePolygon courtyard = rectangle(10, 10);
  courtyard.push_back({{3000, 3000}, {3000, 7000}, {7000, 7000}, {7000, 3000}});
  const RoofSolid s = extrude_roof(part(courtyard, {}), std::vector<RoofPlane>{plane_of(0, 0, 5)}, 0);
  EXPECT_TRUE(closed(s));
  EXPECT_NEAR(volume(s), 84 * 5, 1e-9);
  EXPECT_TRUE(faults_of(s).empty());
}

TEST(RoofSolid, HighFacesThatMeetInACornerDoNotPinchTheSolid) {
  const std::vector<FlatEdge> cross{{{5, -1}, {5, 7}}, {{-1, 3}, {11, 3}}};
  const Partition p = part(rectangle(10, 6), cross);
  ASSERT_EQ(p.regions, 4u);
  // Two opposite quarters high, the others low: which they are is read from where they lie.
  const std::vector<std::uint32_t> at =
      regions_of(p, std::vector<FlatPoint>{{1000, 1000}, {9000, 1000}, {1000, 5000}, {9000, 5000}});
  std::vector<RoofPlane> planes(4);
  for (std::size_t i = 0; i < 4; ++i) planes[at[i] - 1] = plane_of(0, 0, i == 0 || i == 3 ? 8 : 5);
  const RoofSolid s = extrude_roof(p, planes, 0);
  EXPECT_TRUE(closed(s));
  EXPECT_TRUE(faults_of(s).empty());
  EXPECT_NEAR(volume(s), 60 * 6.5, 0.01);
}

TEST(RoofSolid, TheFloorGivesWayToLowRoofs) {
  const RoofSolid s = extrude_roof(part(rectangle(10, 6), {}), std::vector<RoofPlane>{plane_of(0, 0, 1)}, 2);
  EXPECT_NEAR(s.floor, 0.9, 1e-12);
  EXPECT_TRUE(faults_of(s).empty());
}

// Whatever the cells and planes, the solid is closed and holds what lies under the roof.
TEST(RoofSolid, RandomRoofsAreClosed) {
  Rng rng(5);
  int valid = 0;
  constexpr int kRounds = 200;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<FlatEdge> lines;
    for (std::uint64_t i = 1 + rng.below(6); i-- > 0;)
      lines.push_back(
          {{14 * rng.uniform() - 2, 10 * rng.uniform() - 2}, {14 * rng.uniform() - 2, 10 * rng.uniform() - 2}});
    const Partition p = part(rectangle(10, 6), lines);
    std::vector<RoofPlane> planes;
    for (std::uint32_t r = 0; r < p.regions; ++r)
      planes.push_back(plane_of(rng.uniform() - 0.5, rng.uniform() - 0.5, 12 + 2 * rng.uniform()));
    const RoofSolid s = extrude_roof(p, planes, 0);
    ASSERT_TRUE(closed(s)) << "round " << round;
    double under = 0;
    const std::vector<double> areas = region_areas(p);
    ASSERT_GT(volume(s), 0);
    for (std::uint32_t r = 1; r <= p.regions; ++r) under += areas[r];
    ASSERT_LT(volume(s), under * 20);
    valid += faults_of(s).empty();
  }
  EXPECT_GE(valid, kRounds * 98 / 100);
}

}  // namespace
}  // namespace ilot
