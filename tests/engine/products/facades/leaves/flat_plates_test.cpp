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
  const std::vector<FlatPlate> plates = find_flat_plates(RaySamples(site)).plates;
  ASSERT_NE(leaf_of(plates), nullptr);
  expect_plate(*leaf_of(plates));
}

// Twice the scatter: single points do not show it, their means do.
TEST(FlatPlates, APlateOnARoughWall) {
  const FacadeSite site = plate_with_noise(0.017);
  const std::vector<FlatPlate> plates = find_flat_plates(RaySamples(site)).plates;
  ASSERT_NE(leaf_of(plates), nullptr);
  expect_plate(*leaf_of(plates));
}

TEST(FlatPlates, ARoughWallAloneHasNone) {
  test::ScannedWall wall;
  wall.wall({});
  const FacadeSite site = test::scan_wall(wall, {1.5, 1.4, 8}, 0.002, 999, 0.017);
  EXPECT_TRUE(find_flat_plates(RaySamples(site)).plates.empty());
}

// Leaves 4 cm before a wall on both sides of a pier 24 cm wide. Surrounds 9 cm wide and 2.2 cm out leave 6 cm of it.
TEST(FlatPlates, LeavesOnBothSidesOfANarrowPierAreTwo) {
  test::ScannedWall wall;
  wall.wall({});
  for (const double u : {1.5, 2.74}) {
    wall.block(u, u + 1, 1.5, 3.2, 0.04, 0);
    wall.block(u - 0.09, u, 1.5, 3.2, 0.022, 0);
    wall.block(u + 1, u + 1.09, 1.5, 3.2, 0.022, 0);
  }
  const FacadeSite site = test::scan_wall(wall, {2.6, 1.4, 8}, 0.006, 999, 0.002);
  std::vector<FlatPlate> plates = find_flat_plates(RaySamples(site)).plates;
  std::erase_if(plates, [](const FlatPlate& p) { return p.shape.box().width() < 0.5; });
  ASSERT_EQ(plates.size(), 2u);
  for (const FlatPlate& plate : plates) {
    const double u = plate.shape.at(Side::left) < 2 ? 1.5 : 2.74;
    EXPECT_NEAR(plate.shape.at(Side::left), u, plate.shape.error(Side::left));
    EXPECT_NEAR(plate.shape.at(Side::right), u + 1, plate.shape.error(Side::right));
    for (const Side side : kSides) EXPECT_TRUE(plate.ends_at(side));
  }
}

}  // namespace
}  // namespace ilot
