// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/front_image.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ilot {
namespace {

TEST(FrontImage, TheForemostGiveTheColour) {
  const std::vector<FrontPoint> points{
      {0, 100, {10, 20, 30}}, {0, 95, {13, 20, 30}}, {0, 50, {200, 200, 200}}, {2, -7, {1, 2, 3}}};
  FrontImage image(3);
  keep_front(image, points);
  add_colours(image, points, 10);
  EXPECT_EQ(mean_colours(image), (std::vector<std::uint8_t>{12, 20, 30, 255, 0, 0, 0, 0, 1, 2, 3, 255}));
}

TEST(FrontImage, PointsInAnyOrderAndAnyPiecesGiveTheSame) {
  std::vector<FrontPoint> points;
  for (std::uint32_t i = 0; i < 1000; ++i)
    points.push_back(
        {(i * 7919) % 16, static_cast<std::int32_t>((i * 104729) % 50), {static_cast<std::uint8_t>(i), 3, 9}});
  FrontImage once(16), turned(16);
  keep_front(once, points);
  add_colours(once, points, 5);
  std::reverse(points.begin(), points.end());
  for (const FrontPoint& p : points) keep_front(turned, {&p, 1});
  for (const FrontPoint& p : points) add_colours(turned, {&p, 1}, 5);
  EXPECT_EQ(mean_colours(once), mean_colours(turned));
}

TEST(FrontImage, GapsCloseAndOpeningsStay) {
  constexpr std::uint32_t kSize = 12;
  std::vector<std::uint8_t> rgba(4 * kSize * kSize, 100);
  const auto clear = [&](std::uint32_t x, std::uint32_t y) {
    std::fill_n(rgba.begin() + 4 * (y * kSize + x), 4, std::uint8_t{0});
  };
  for (std::uint32_t y = 0; y < kSize; ++y) clear(1, y), clear(2, y);  // two wide
  for (std::uint32_t y = 4; y < 10; ++y)
    for (std::uint32_t x = 5; x < 11; ++x) clear(x, y);
  EXPECT_EQ(fill_gaps(rgba, kSize, kSize, 0), 0u);
  const std::uint64_t filled = fill_gaps(rgba, kSize, kSize, 1);
  EXPECT_EQ(rgba[4 * (5 * kSize + 1)], 100);
  EXPECT_EQ(rgba[4 * (5 * kSize + 2) + 3], 255);
  for (std::uint32_t y = 5; y < 9; ++y)
    for (std::uint32_t x = 6; x < 10; ++x) EXPECT_EQ(rgba[4 * (y * kSize + x) + 3], 0);
  // All of the gap but its ends, where an empty pixel has but two neighbours; the opening's border of one.
  EXPECT_EQ(filled, 2 * kSize - 4 + 20u);
}

TEST(FrontImage, NothingAroundNothing) {
  std::vector<std::uint8_t> one(4, 0), none;
  EXPECT_EQ(fill_gaps(one, 1, 1, 5), 0u);
  EXPECT_EQ(fill_gaps(none, 0, 0, 5), 0u);
  EXPECT_TRUE(mean_colours(FrontImage(0)).empty());
}

}  // namespace
}  // namespace ilot
