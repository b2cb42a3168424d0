// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/terrain.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"
#include "tests/support/memory_layers.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

constexpr double kCell = 0.5;  // metres

Cells cells_with(const test::MemoryLayers& memory) {
  return {1, {0.001, kCell}, memory.layers};
}

Image terrain_of(const Image& lowest, std::uint32_t side) {
  test::MemoryLayers memory({lowest.width, lowest.height, side});
  memory.put("lowest", lowest);
  find_terrain(cells_with(memory));
  return memory.whole("terrain");
}

// Ground of 100 m x 80 m that rises by 20 %, with noise.
Image slope() {
  Rng rng(2);
  Image image = filled_image(200, 160, 0);
  for (std::size_t i = 0; i < image.size(); ++i)
    image.values[i] = static_cast<Height>(100 * (i % 200)) + static_cast<Height>(rng.below(20));
  return image;
}

void expect_near(const Image& terrain, const Image& truth, Height tolerance, const char* what) {
  for (std::size_t i = 0; i < truth.size(); ++i)
    ASSERT_NEAR(terrain.values[i], truth.values[i], tolerance)
        << what << " " << i % truth.width << " " << i / truth.width;
}

TEST(Terrain, FollowsSlopesBelowHousesAndCars) {
  const Image truth = slope();
  Image lowest = truth;
  test::put(lowest, {20, 20, 24, 26}, 6000);   // a house of 12 m
  test::put(lowest, {100, 100, 9, 4}, 900);    // a car
  test::put(lowest, {150, 20, 20, 20}, 3000);  // a crown
  lowest.values[80 * 200 + 90] -= 4000;        // a mirrored point
  const Image terrain = terrain_of(lowest, 64);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    // Below what stands it is that of the nearest ground.
    const Height tolerance = lowest.values[i] == truth.values[i] ? 1 : 100 * 14 + 20;
    ASSERT_NEAR(terrain.values[i], truth.values[i], tolerance) << i;
  }
}

TEST(Terrain, TerracesAndYardsAreGround) {
  Image truth = filled_image(160, 120, 0);
  test::put(truth, {0, 0, 40, 120}, 1000);   // a terrace beside the street
  test::put(truth, {100, 40, 20, 24}, 700);  // a garden of 10 m x 12 m that is raised all around
  Image lowest = truth;
  test::put(lowest, {60, 0, 20, 120}, 9000);  // a row of houses from end to end
  const Image terrain = terrain_of(lowest, 50);
  for (std::size_t i = 0; i < truth.size(); ++i)
    ASSERT_TRUE(lowest.values[i] != truth.values[i] || terrain.values[i] == truth.values[i])
        << i % 160 << " " << i / 160;
}

// Bumper, bonnet and roof are joined to the ground by small steps.
TEST(Terrain, ACarOfSmallStepsIsNone) {
  Image lowest = filled_image(80, 80, 0);
  test::put(lowest, {30, 30, 10, 5}, 330);
  test::put(lowest, {31, 31, 8, 3}, 330);
  test::put(lowest, {32, 31, 6, 3}, 330);
  test::put(lowest, {33, 31, 4, 3}, 330);
  const Image terrain = terrain_of(lowest, 30);
  for (const Height v : terrain.values) ASSERT_LE(v, 330) << "the bumper's cells are near enough to the ground";
}

TEST(Terrain, ALargeFlatRoofIsNone) {
  Image lowest = filled_image(240, 240, 0);
  test::put(lowest, {60, 60, 110, 110}, 5000);  // 55 m x 55 m
  const Image terrain = terrain_of(lowest, 100);
  EXPECT_EQ(terrain.values[115 * 240 + 115], 0);
}

TEST(Terrain, TheTilesDoNotDecide) {
  const Image truth = slope();
  const Image want = terrain_of(truth, 200);
  expect_near(terrain_of(truth, 32), want, 0, "side 32");
  expect_near(terrain_of(truth, 70), want, 0, "side 70");
  const Image nothing = terrain_of(filled_image(3, 2, kNoHeight), 2);
  for (const Height v : nothing.values) EXPECT_EQ(v, kNoHeight);
}

}  // namespace
}  // namespace ilot
