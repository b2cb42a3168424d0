// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/outward_drops.h"

#include <gtest/gtest.h>

#include <numeric>

#include "kernels/core/rng.h"
#include "kernels/morphology/flat_zones.h"

namespace ilot {
namespace {

TEST(OutwardDrops, ARoofDropsAllAroundAndAPitRises) {
  Image image = filled_image(7, 7, 10);
  for (const std::size_t y : {2, 3, 4})
    for (const std::size_t x : {2, 3, 4}) image.values[y * 7 + x] = 100;
  const PixelLabels zones = flat_zones(image, 5, Adjacency::eight);
  // Corners have five lower neighbours, the middles of the sides three.
  EXPECT_EQ(outward_drops(image, zones, 5), (std::vector<std::int32_t>{0, -32, 32}));
  for (Height& v : image.values) v = -v;
  EXPECT_EQ(outward_drops(image, zones, 5), (std::vector<std::int32_t>{0, 32, -32}));
}

TEST(OutwardDrops, StepsAsSmallAsLambdaAndPixelsWithoutAHeightCountForNothing) {
  const Image image{3, 1, {0, 5, kNoHeight}};
  EXPECT_EQ(outward_drops(image, flat_zones(image, 5, Adjacency::eight), 5), (std::vector<std::int32_t>{0, 0}));
  EXPECT_EQ(outward_drops(image, flat_zones(image, 4, Adjacency::eight), 4), (std::vector<std::int32_t>{0, -1, 1}));
  EXPECT_EQ(outward_drops({}, {}, 1), (std::vector<std::int32_t>{0}));
}

// Every pixel asks all its neighbours.
TEST(OutwardDrops, AsCountedPixelByPixel) {
  Rng rng(5);
  for (int round = 0; round < 40; ++round) {
    Image image =
        filled_image(1 + static_cast<std::uint32_t>(rng.below(12)), 1 + static_cast<std::uint32_t>(rng.below(12)), 0);
    for (Height& v : image.values) v = rng.below(6) == 0 ? kNoHeight : static_cast<Height>(rng.below(30));
    const PixelLabels zones = flat_zones(image, 4, Adjacency::eight);
    std::vector<std::int32_t> want(zones.count + 1, 0);
    const auto w = static_cast<int>(image.width), h = static_cast<int>(image.height);
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        for (int v = std::max(0, y - 1); v <= std::min(h - 1, y + 1); ++v)
          for (int u = std::max(0, x - 1); u <= std::min(w - 1, x + 1); ++u) {
            const Height a = image.values[static_cast<std::size_t>(y * w + x)],
                         b = image.values[static_cast<std::size_t>(v * w + u)];
            if (a == kNoHeight || b == kNoHeight || std::abs(a - b) <= 4) continue;
            want[zones.of[static_cast<std::size_t>(y * w + x)]] += a > b ? 1 : -1;
          }
    const std::vector<std::int32_t> got = outward_drops(image, zones, 4);
    EXPECT_EQ(got, want);
    EXPECT_EQ(std::accumulate(got.begin(), got.end(), 0), 0);
  }
}

}  // namespace
}  // namespace ilot
