// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/wall_areas.h"

#include <gtest/gtest.h>

#include "tests/support/buildings.h"

namespace ilot {
namespace {

// The house of 10 m x 8 m: eaves at 3 m, gables up to 6 m at x = 0 and x = 10. Walls: 2 x 30 + 2 x 36 m2.
constexpr double kAllWalls = 132;

RoofSite site_with(const std::vector<Vec3>& beside) {
  RoofSite site;
  site.beside = beside;
  return site;
}

// Points of a neighbour's roof in a strip of half a metre beside x = 10.
std::vector<Vec3> beside_east(double height, double from, double to) {
  std::vector<Vec3> points;
  for (double y = from + 0.1; y < to; y += 0.2) points.push_back({10.3, y, height});
  return points;
}

SitePolygon rectangle(int x0, int y0, int x1, int y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

TEST(WallAreas, WithoutNeighboursAllWallsAreExterior) {
  const WallAreas areas = wall_areas(gable_house("a", {}), site_with(beside_east(9, 0, 8)), {}, 1);
  EXPECT_EQ(areas.party, 0);
  EXPECT_NEAR(areas.exterior, kAllWalls, 1e-9);
}

TEST(WallAreas, ATallNeighbourCoversTheWall) {
  const std::vector<SitePolygon> east{rectangle(10000, 0, 15000, 8000)};
  const WallAreas areas = wall_areas(gable_house("a", {}), site_with(beside_east(9, 0, 8)), east, 1);
  EXPECT_GT(areas.party, 23.99);
  EXPECT_LE(areas.party, 36) << "not more than the wall";
  EXPECT_NEAR(areas.party + areas.exterior, kAllWalls, 1e-9);
}

TEST(WallAreas, ALowNeighbourCoversTheWallUpToItsRoof) {
  const std::vector<SitePolygon> east{rectangle(10000, 2000, 15000, 7000)};
  const WallAreas areas = wall_areas(gable_house("a", {}), site_with(beside_east(2, 2, 7)), east, 1);
  EXPECT_NEAR(areas.party, 5 * 2, 1e-9);
}

TEST(WallAreas, AGapOfLessThanTwentyCentimetresIsAWall) {
  for (const auto& [gap, shared] : {std::pair(0, true), {150, true}, {-150, true}, {250, false}}) {
    const std::vector<SitePolygon> east{rectangle(10000 + gap, 0, 15000, 8000)};
    const WallAreas areas = wall_areas(gable_house("a", {}), site_with(beside_east(2, 0, 8)), east, 1);
    EXPECT_NEAR(areas.party, shared ? 16 : 0, 1e-9) << gap;
  }
}

TEST(WallAreas, WhereNoPointShowsARoofThereIsNone) {
  const std::vector<SitePolygon> east{rectangle(10000, 0, 15000, 8000)};
  EXPECT_EQ(wall_areas(gable_house("a", {}), site_with({}), east, 1).party, 0);
}

TEST(WallAreas, NeighboursThatOverlapCountOnce) {
  const std::vector<SitePolygon> east{rectangle(10000, 0, 15000, 6000), rectangle(10000, 2000, 15000, 8000)};
  const WallAreas areas = wall_areas(gable_house("a", {}), site_with(beside_east(2, 0, 8)), east, 1);
  EXPECT_NEAR(areas.party, 16, 1e-9);
}

TEST(WallAreas, AWallAcrossIsNone) {
  const std::vector<SitePolygon> across{{{{10000, 4000}, {15000, 3000}, {15000, 4000}}}};
  EXPECT_EQ(wall_areas(gable_house("a", {}), site_with(beside_east(2, 0, 8)), across, 1).party, 0);
}

TEST(WallAreas, FeetAreConverted) {
  const double foot = 0.3048;
  Building house = gable_house("a", {});
  for (Vec3& v : house.vertices) v = (1 / foot) * v;
  const std::vector<SitePolygon> east{rectangle(10000, 0, 15000, 8000)};
  const WallAreas areas = wall_areas(house, site_with(beside_east(2, 0, 8)), east, foot);
  EXPECT_NEAR(areas.party, 16, 1e-6);
  EXPECT_NEAR(areas.party + areas.exterior, kAllWalls, 1e-6);
}

}  // namespace
}  // namespace ilot
