// SPDX-License-Identifier: Apache-2.0
#include "engine/model/building_geometry.h"

#include <gtest/gtest.h>

#include "tests/support/buildings.h"

namespace ilot {
namespace {

TEST(BuildingGeometry, MeasuresRoofs) {
  const Building house = gable_house("a", {100, 200, 3});
  const SurfaceShape south = surface_shape(house, house.surfaces[0], 1),
                     north = surface_shape(house, house.surfaces[1], 1);
  EXPECT_NEAR(south.area_m2, 10 * 5, 1e-12);
  EXPECT_NEAR(south.slope_deg, 36.86989764584402, 1e-11);
  EXPECT_NEAR(south.azimuth_deg, 180, 1e-11);
  EXPECT_NEAR(north.azimuth_deg, 0, 1e-11);
  EXPECT_NEAR(surface_shape(house, house.surfaces[0], 0.5).area_m2, 12.5, 1e-12);
}

TEST(BuildingGeometry, LevelFacesLookNowhere) {
  const Building house = gable_house("a", {});
  EXPECT_EQ(surface_shape(house, house.surfaces.back(), 1).azimuth_deg, -1);
  EXPECT_EQ(surface_shape(house, {SurfaceKind::roof, 0, {}}, 1).area_m2, 0);
  EXPECT_EQ(surface_shape(house, {SurfaceKind::roof, 0, {{0, 1, 1}}}, 1).slope_deg, 0);
}

TEST(BuildingGeometry, MeasuresVolumes) {
  EXPECT_NEAR(volume_m3(gable_house("a", {652000, 6862000, 3}), 1), 8 * 10 * 3 + 8 * 10 * 3 / 2.0, 1e-6);
  EXPECT_NEAR(volume_m3(gable_house("a", {}), 0.5), 360 / 8.0, 1e-9);
  EXPECT_EQ(volume_m3(Building{}, 1), 0);
}

}  // namespace
}  // namespace ilot
