// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/ground.h"

#include <gtest/gtest.h>

#include "tests/oracles/whole_street.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

using test::put;

TEST(Ground, IsTheStreetBetweenTheFacades) {
  Image range = test::sloping_street(200, 100, 0);
  put(range, {50, 40, 4, 4}, 6000);  // a lamppost: a zone of its own, enclosed
  const test::Ground ground = test::find_ground(range, {});
  for (std::uint32_t y = 0; y < 100; ++y)
    for (std::uint32_t x = 0; x < 200; ++x)
      ASSERT_EQ(ground.mask[y * 200 + x], y >= test::kFacade && y < 100 - test::kFacade) << x << " " << y;
}

// A shadow right across the street leaves two grounds; the link makes one of them, and the gaps left and right of it
// touch the border no more.
TEST(Ground, AShadowAcrossTheStreetIsBridged) {
  Image range = test::sloping_street(300, 100, 2);
  put(range, {120, test::kFacade, 30, 100 - 2 * test::kFacade}, kNoHeight);
  const test::Ground ground = test::find_ground(range, {});
  EXPECT_EQ(ground.mask[50 * 300 + 10], 1);
  EXPECT_EQ(ground.mask[50 * 300 + 290], 1);
  EXPECT_EQ(ground.mask[5 * 300 + 10], 0);
  EXPECT_EQ(ground.mask[50 * 300 + 135], 1);
}

// A hole in the scan that a chain of corners joins to the border stays without a height, though from side to side the
// ground encloses it: it is no ground.
TEST(Ground, WhatHasNoHeightIsNone) {
  Image range = filled_image(120, 120, 0);
  for (std::uint32_t y = 0; y < 120; ++y)
    for (std::uint32_t x = y; x < 120; ++x) range.values[y * 120 + x] = x == y && x < 60 ? kNoHeight : 300;
  put(range, {60, 60, 40, 40}, kNoHeight);
  const test::Ground ground = test::find_ground(range, {});
  EXPECT_EQ(ground.filled.values[80 * 120 + 80], kNoHeight);
  EXPECT_EQ(ground.mask[80 * 120 + 80], 0);
  EXPECT_EQ(ground.mask[50 * 120 + 10], 1);
}

// A roof that is larger than each of the pieces of ground around it.
TEST(Ground, ALargeRoofIsNone) {
  const Image range = test::large_roof();
  const test::Ground ground = test::find_ground(range, {});
  EXPECT_EQ(ground.mask[60 * range.width + 100], 0) << "on the roof";
  EXPECT_EQ(ground.mask[60 * range.width + 5], 1) << "the larger piece of ground";
}

// What is far smaller than the largest is not the ground, even if all else falls to it.
TEST(Ground, ASmallYardIsNone) {
  Image range = filled_image(200, 120, 5000);
  put(range, {90, 50, 20, 20}, -4000);
  const test::Ground ground = test::find_ground(range, {});
  EXPECT_EQ(ground.mask[10 * 200 + 10], 1);
}

TEST(Ground, NothingAndOnePixel) {
  EXPECT_TRUE(test::find_ground({}, {}).mask.empty());
  EXPECT_EQ(test::find_ground(filled_image(3, 2, kNoHeight), {}).mask, (std::vector<std::uint8_t>(6, 0)));
  EXPECT_EQ(test::find_ground(filled_image(1, 1, 5), {}).mask, (std::vector<std::uint8_t>{1}));
}

TEST(Ground, FollowsTheMirror) {
  Image range = test::sloping_street(150, 90, 4);
  put(range, {20, 30, 40, 12}, 1500);
  put(range, {20, 42, 40, 12}, kNoHeight);
  const test::Ground ground = test::find_ground(range, {}), mirror = test::find_ground(test::mirrored(range), {});
  for (std::size_t y = 0; y < 90; ++y)
    for (std::size_t x = 0; x < 150; ++x) ASSERT_EQ(ground.mask[y * 150 + x], mirror.mask[y * 150 + 149 - x]);
}

}  // namespace
}  // namespace ilot
