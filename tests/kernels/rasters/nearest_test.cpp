// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/nearest.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// By the definition: every pixel with a height is looked at, in order.
void expect_nearest(const Image& image, std::uint32_t reach) {
  const NearestPixels found = nearest_pixels(image, reach);
  ASSERT_EQ(found.pixel.size(), image.size());
  for (std::uint32_t p = 0; p < image.size(); ++p) {
    std::uint32_t pixel = kNoNearest, distance = reach + 1;
    for (std::uint32_t q = 0; q < image.size(); ++q) {
      if (image.values[q] == kNoHeight) continue;
      const auto steps =
          static_cast<std::uint32_t>(std::abs(static_cast<int>(p % image.width) - static_cast<int>(q % image.width)) +
                                     std::abs(static_cast<int>(p / image.width) - static_cast<int>(q / image.width)));
      if (steps < distance) distance = steps, pixel = q;
    }
    ASSERT_EQ(found.pixel[p], pixel) << p;
    ASSERT_EQ(found.distance[p], distance) << p;
  }
}

TEST(Nearest, OfEquallyNearTheFirst) {
  Image image = filled_image(5, 3, kNoHeight);
  image.values[2] = image.values[12] = 7;  // above and below the middle
  const NearestPixels found = nearest_pixels(image, 1);
  EXPECT_EQ(found.pixel[7], 2u);
  EXPECT_EQ(found.pixel[12], 12u);
  EXPECT_EQ(found.pixel[0], kNoNearest);
  EXPECT_EQ(found.distance[0], 2u);
}

TEST(Nearest, AsByLookingAtAll) {
  Rng rng(1, 9);
  for (const std::uint32_t width : {1u, 2u, 7u, 8u, 9u, 31u})
    for (const std::uint32_t height : {1u, 3u, 4u, 5u, 23u})
      for (const std::uint32_t one_in : {1u, 3u, 40u, 2000u}) {
        Image image = filled_image(width, height, kNoHeight);
        for (Height& v : image.values)
          if (rng.below(one_in) == 0) v = static_cast<Height>(rng.below(9)) - 4;
        for (const std::uint32_t reach : {0u, 1u, 5u, 100u, 0x7ffffff0u}) expect_nearest(image, reach);
      }
}

TEST(Nearest, OfNoPixelNone) {
  EXPECT_TRUE(nearest_pixels({}, 3).pixel.empty());
}

}  // namespace
}  // namespace ilot
