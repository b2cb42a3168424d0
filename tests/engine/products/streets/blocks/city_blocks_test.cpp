// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/blocks/city_blocks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/memory_layers.h"

namespace ilot {
namespace {

// A wall of 8 m on level ground, aslant, with gaps (metres along it); at 10 pixels a metre, in millimetres.
void fill(test::MemoryLayers& memory, std::uint32_t width, std::uint32_t height,
          const std::vector<std::pair<double, double>>& gaps) {
  Image range = filled_image(width, height, 0), mask = filled_image(width, height, 1), level = range,
        accumulation = filled_image(width, height, 2);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const double across = -0.28 * x + 0.96 * y - 60, along = (0.96 * x + 0.28 * y) / 10;
      if (std::abs(across) > 2) continue;
      bool open = false;
      for (const auto& [from, to] : gaps) open |= along > from && along < to;
      if (open) continue;
      const std::size_t i = std::size_t{y} * width + x;
      range.values[i] = 8000;
      mask.values[i] = 0;
      accumulation.values[i] = 40;
    }
  memory.put("range", range);
  memory.put("mask", mask);
  memory.put("level", level);
  memory.put("accumulation", accumulation);
}

TEST(CityBlocks, StreetsBetweenThem) {
  const RasterScale scale{0.001, 0.1};
  for (const std::uint32_t side : {256u, 700u}) {
    test::MemoryLayers memory({1600, 700, side});
    fill(memory, 1600, 700, {{40, 49}, {100, 106}});
    const auto stretches = find_city_blocks(memory.layers, scale);
    ASSERT_EQ(stretches.size(), 1u);
    const StreetStretch& s = stretches[0];
    EXPECT_NEAR(s.dx, 0.96, 0.002);
    EXPECT_NEAR(s.dy, 0.28, 0.002);
    ASSERT_EQ(s.gaps.size(), 2u);
    ASSERT_EQ(s.blocks.size(), 3u);
    const double begin = (0.96 * s.x + 0.28 * s.y) / 10;
    EXPECT_NEAR(begin + s.gaps[0].from, 40, 0.7);
    EXPECT_NEAR(begin + s.gaps[0].to, 49, 0.7);
    EXPECT_NEAR(begin + s.gaps[1].from, 100, 0.7);
    EXPECT_NEAR(begin + s.gaps[1].to, 106, 0.7);
    EXPECT_NEAR(s.blocks[1].height, 8, 0.01);
  }
}

TEST(CityBlocks, NoneWithoutFacades) {
  const RasterScale scale{0.001, 0.1};
  test::MemoryLayers memory({300, 300, 128});
  fill(memory, 300, 300, {{-1000, 1000}});
  EXPECT_TRUE(find_city_blocks(memory.layers, scale).empty());
}

// A doorway is no street.
TEST(CityBlocks, NarrowGapsDoNotCut) {
  const RasterScale scale{0.001, 0.1};
  test::MemoryLayers memory({1600, 700, 700});
  fill(memory, 1600, 700, {{60, 61.5}});
  const auto stretches = find_city_blocks(memory.layers, scale);
  ASSERT_EQ(stretches.size(), 1u);
  EXPECT_TRUE(stretches[0].gaps.empty());
  EXPECT_EQ(stretches[0].blocks.size(), 1u);
}

}  // namespace
}  // namespace ilot
