// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/flat_plates.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

// A plate 3.5 cm before a wall, with a sill below it.
FacadeSite plate_with_noise(double noise) {
  test::ScannedWall wall;
  wall.wall({});
  wall.block(2.6, 3.7, 1.5, 3.2, 0.035, 0);
  wall.block(2.5, 3.8, 1.35, 1.5, 0.12, 0);
  return test::scan_wall(wall, {1.5, 1.4, 8}, 0.002, 999, noise);
}

void expect_plate(const FlatPlate& plate) {
  EXPECT_NEAR(plate.shape.at(Side::left), 2.6, plate.shape.error(Side::left));
  EXPECT_NEAR(plate.shape.at(Side::right), 3.7, plate.shape.error(Side::right));
  EXPECT_NEAR(plate.shape.at(Side::bottom), 1.5, plate.shape.error(Side::bottom));
  EXPECT_NEAR(plate.shape.at(Side::top), 3.2, plate.shape.error(Side::top));
  EXPECT_NEAR(plate.shape.depth, 0.035, 0.01);
  EXPECT_TRUE(plate.ends_at(Side::left) && plate.ends_at(Side::right) && plate.ends_at(Side::top));
  EXPECT_FALSE(plate.ends_at(Side::bottom));  // the sill hides how far it goes
}

const FlatPlate* leaf_of(const std::vector<FlatPlate>& plates) {
  for (const FlatPlate& p : plates)
    if (p.shape.box().height() > 1) return &p;
  return nullptr;
}

TEST(FlatPlates, APlateOnASmoothWall) {
  const FacadeSite site = plate_with_noise(0.003);
  const std::vector<FlatPlate> plates = find_flat_plates(RaySamples(site));
  ASSERT_NE(leaf_of(plates), nullptr);
  expect_plate(*leaf_of(plates));
}

// Twice the scatter: single points do not show it, their means do.
TEST(FlatPlates, APlateOnARoughWall) {
  const FacadeSite site = plate_with_noise(0.017);
  const std::vector<FlatPlate> plates = find_flat_plates(RaySamples(site));
  ASSERT_NE(leaf_of(plates), nullptr);
  expect_plate(*leaf_of(plates));
}

TEST(FlatPlates, ARoughWallAloneHasNone) {
  test::ScannedWall wall;
  wall.wall({});
  const FacadeSite site = test::scan_wall(wall, {1.5, 1.4, 8}, 0.002, 999, 0.017);
  EXPECT_TRUE(find_flat_plates(RaySamples(site)).empty());
}

}  // namespace
}  // namespace ilot
