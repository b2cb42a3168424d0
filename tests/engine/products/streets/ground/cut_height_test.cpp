// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/cut_height.h"

#include <gtest/gtest.h>

#include "tests/support/memory_layers.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

constexpr std::uint32_t kCutSide = 60;
constexpr double kStorey = 2.5;

double share_of(const Image& above, std::uint32_t tile) {
  Image terrain = filled_image(kCutSide, kCutSide, 0), highest = above;
  for (std::size_t i = 0; i < terrain.size(); ++i) {
    terrain.values[i] = static_cast<Height>(10 * (i % kCutSide));  // a street that rises
    if (highest.values[i] != kNoHeight) highest.values[i] += terrain.values[i];
  }
  test::MemoryLayers memory({kCutSide, kCutSide, tile});
  memory.put("terrain", terrain);
  memory.put("highest", highest);
  return height_share({1, {0.001, 0.4}, memory.layers}, kStorey);
}

// Ground, a row of walls of a height, and lower things before it.
Image street_with_walls(Height walls) {
  Image above = filled_image(kCutSide, kCutSide, 0);
  test::put(above, {0, 4, kCutSide, 3}, walls);
  test::put(above, {10, 20, 10, 4}, 1000);
  return above;
}

TEST(CutHeight, IsThatOfNearlyAllThatStands) {
  for (const std::uint32_t tile : {16u, 60u}) {
    EXPECT_DOUBLE_EQ(share_of(street_with_walls(9000), tile), 1);
    EXPECT_DOUBLE_EQ(share_of(street_with_walls(2500), tile), 1);
    EXPECT_DOUBLE_EQ(share_of(street_with_walls(1250), tile), 0.5);
  }
}

TEST(CutHeight, AStrayAboveTheCutDoesNotCount) {
  Image above = street_with_walls(1250);
  test::put(above, {30, 30, 1, 1}, 8000);
  EXPECT_DOUBLE_EQ(share_of(above, 60), 0.5);
  EXPECT_DOUBLE_EQ(share_of(filled_image(kCutSide, kCutSide, 20), 60), 1) << "nothing stands";
  EXPECT_DOUBLE_EQ(share_of(filled_image(kCutSide, kCutSide, kNoHeight), 60), 1);
}

}  // namespace
}  // namespace ilot
