// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/building_mask.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

constexpr std::uint32_t kSide = 30;

std::vector<HighPoints> scene() {
  std::vector<HighPoints> pixels(kSide * kSide);
  const auto fill = [&](std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1, HighPoints p) {
    for (std::uint32_t y = y0; y < y1; ++y)
      for (std::uint32_t x = x0; x < x1; ++x) pixels[y * kSide + x] = p;
  };
  fill(3, 3, 12, 10, {10, 9});    // a roof
  fill(18, 3, 27, 12, {12, 1});   // a tree
  fill(3, 20, 27, 21, {10, 10});  // a cable, a pixel wide
  return pixels;
}

TEST(BuildingMask, RoofsAreInTreesAreOut) {
  const auto mask = building_mask(scene(), kSide, kSide);
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const bool roof = x >= 3 && x < 12 && y >= 3 && y < 10;
      if (roof) {
        EXPECT_EQ(mask[y * kSide + x], 1) << x << " " << y;
      }
      if (x >= 15 && y < 15) {
        EXPECT_EQ(mask[y * kSide + x], 0) << x << " " << y;
      }
    }
  }
}

TEST(BuildingMask, PartsWithTheirHaloGiveTheWhole) {
  const auto pixels = scene();
  const auto whole = building_mask(pixels, kSide, kSide);
  constexpr std::uint32_t kFrom = 8, kTo = 15, kLow = kFrom - kMaskHalo, kPart = kTo - kFrom + 2 * kMaskHalo;
  std::vector<HighPoints> part;
  for (std::uint32_t y = 0; y < kPart; ++y)
    for (std::uint32_t x = 0; x < kPart; ++x) part.push_back(pixels[(y + kLow) * kSide + x + kLow]);
  const auto found = building_mask(part, kPart, kPart);
  for (std::uint32_t y = kFrom; y < kTo; ++y)
    for (std::uint32_t x = kFrom; x < kTo; ++x) EXPECT_EQ(found[(y - kLow) * kPart + x - kLow], whole[y * kSide + x]);
}

}  // namespace
}  // namespace ilot
