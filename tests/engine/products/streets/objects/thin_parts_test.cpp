// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/thin_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/street_images.h"

namespace ilot {
namespace {

constexpr std::uint32_t kThinWidth = 40, kThinHeight = 30;
constexpr Occupancy kThinPost = 0b11'1111'1111, kThinLeaf = 0b11'0000'0000;  // 1 m from the ground; 20 cm above 80 cm

// Pixels of 5 cm and bins of 10. What stands in some of them, and no parts yet.
struct ThinStreet {
  Image heights = filled_image(kThinWidth, kThinHeight, kNoHeight);
  std::vector<Occupancy> occupancy = std::vector<Occupancy>(kThinWidth * kThinHeight, 0);
  PixelLabels parts{kThinWidth, kThinHeight, 0, std::vector<std::uint32_t>(kThinWidth* kThinHeight, 0)};

  void add(std::uint32_t x, std::uint32_t y, Occupancy bins, std::uint32_t part = 0) {
    const std::size_t i = y * kThinWidth + x;
    heights.values[i] = 1000, occupancy[i] = bins, parts.of[i] = part;
    parts.count = std::max(parts.count, part);
  }
  const PixelLabels& with_thin_parts() {
    add_thin_parts(heights, occupancy, {}, {}, parts);
    return parts;
  }
  std::uint32_t part_at(std::uint32_t x, std::uint32_t y) const { return parts.of[y * kThinWidth + x]; }
};

TEST(ThinParts, APostOfTwoPixelsIsAPartAfterAllOthers) {
  ThinStreet s;
  for (std::uint32_t x = 5; x < 12; ++x) s.add(x, 5, kThinPost, 1);
  s.add(20, 10, kThinPost), s.add(21, 10, kThinPost);
  s.with_thin_parts();
  EXPECT_EQ(s.parts.count, 2u);
  EXPECT_EQ(s.part_at(20, 10), 2u);
  EXPECT_EQ(s.part_at(21, 10), 2u);
  EXPECT_EQ(s.part_at(5, 5), 1u) << "a part that was there is kept";
}

TEST(ThinParts, ProfilesOfOneColumnAreOnePartAndFarOnesAreTwo) {
  ThinStreet s;
  for (std::uint32_t x = 4; x < 16; x += 2) s.add(x, 10, kThinPost);  // profiles, a sampling step apart
  s.add(30, 10, kThinPost), s.add(33, 10, kThinPost);
  s.with_thin_parts();
  EXPECT_EQ(s.parts.count, 3u);
  for (std::uint32_t x = 4; x < 16; x += 2) EXPECT_EQ(s.part_at(x, 10), 1u) << x;
  EXPECT_NE(s.part_at(30, 10), s.part_at(33, 10));
}

TEST(ThinParts, LeavesAndStraysAreNone) {
  ThinStreet s;
  s.add(10, 10, kThinLeaf), s.add(11, 10, kThinLeaf), s.add(20, 10, 1), s.add(30, 10, 0);
  EXPECT_EQ(s.with_thin_parts().count, 0u);
  EXPECT_TRUE(stands_upright(kThinPost, {}));
  EXPECT_FALSE(stands_upright(0b1010'1010'1010, {})) << "a run of heights, not a number of them";
}

}  // namespace
}  // namespace ilot
