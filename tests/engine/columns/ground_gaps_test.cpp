// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/ground_gaps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr int kWays[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

Image random_ground(std::uint32_t width, std::uint32_t height, double holes, std::uint64_t seed) {
  Rng rng(seed);
  Image image = filled_image(width, height, 0);
  for (Height& v : image.values) v = rng.uniform() < holes ? kNoHeight : static_cast<Height>(rng.below(5000)) - 2000;
  return image;
}

// Walks from the pixel, step by step.
Height walked(const Image& image, std::int64_t x, std::int64_t y, std::int64_t reach) {
  double weight = 0, height = 0;
  bool seen[8] = {};
  for (int k = 0; k < 8; ++k)
    for (std::int64_t step = 1; step <= reach; ++step) {
      const std::int64_t px = x + step * kWays[k][0], py = y + step * kWays[k][1];
      if (px < 0 || py < 0 || px >= image.width || py >= image.height) break;
      const Height v = image.values[static_cast<std::size_t>(py * image.width + px)];
      if (v == kNoHeight) continue;
      const double squared = static_cast<double>((px - x) * (px - x) + (py - y) * (py - y));
      weight += 1 / squared;
      height += v / squared;
      seen[k] = true;
      break;
    }
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < 8; ++b)
      if (const int apart = std::abs(a - b); seen[a] && seen[b] && apart >= 3 && apart <= 5)
        return static_cast<Height>(std::lround(height / weight));
  return kNoHeight;
}

TEST(GroundGaps, AsOneWalksFromEachPixel) {
  for (const double holes : {0.2, 0.7, 0.97}) {
    for (const std::uint32_t reach : {1u, 3u, 40u}) {
      const Image image = random_ground(37, 29, holes, reach);
      const Image filled = filled_ground(image, reach);
      for (std::int64_t y = 0; y < image.height; ++y)
        for (std::int64_t x = 0; x < image.width; ++x) {
          const auto i = static_cast<std::size_t>(y * image.width + x);
          const Height expected = image.values[i] != kNoHeight ? image.values[i] : walked(image, x, y, reach);
          ASSERT_NEAR(filled.values[i], expected, expected == kNoHeight ? 0 : 1) << x << " " << y << " " << reach;
        }
    }
  }
}

TEST(GroundGaps, SmoothingKeepsWhatWasMeasuredAndFlattensTheRest) {
  Image ground = filled_image(9, 9, kNoHeight), filled = filled_image(9, 9, 0);
  ground.values[0] = filled.values[0] = 5000;
  for (std::size_t i = 1; i < filled.size(); ++i) filled.values[i] = (i % 2) * 900;  // a chessboard
  const Image smooth = smoothed_fill(ground, filled);
  EXPECT_EQ(smooth.values[0], 5000);
  for (std::uint32_t y = 3; y < 6; ++y)
    for (std::uint32_t x = 3; x < 6; ++x) EXPECT_NEAR(smooth.values[y * 9 + x], 450, 15);
  EXPECT_EQ(smoothed_fill(ground, ground).values, ground.values) << "nothing is made";
}

TEST(GroundGaps, NothingIsMadeBeyondTheGround) {
  Image image = filled_image(20, 20, kNoHeight);
  for (std::uint32_t y = 0; y < 20; ++y)
    for (std::uint32_t x = 0; x < 5; ++x) image.values[y * 20 + x] = 100;
  const Image filled = filled_ground(image, 50);
  for (std::size_t i = 0; i < image.size(); ++i) EXPECT_EQ(filled.values[i], image.values[i]);
}

TEST(GroundGaps, PartsWithTheirHaloGiveTheWhole) {
  constexpr std::uint32_t kReach = 9, kFrom = 20, kTo = 45;
  const Image whole = random_ground(70, 70, 0.9, 5), filled = filled_ground(whole, kReach);
  constexpr std::uint32_t kWide = kTo - kFrom + 2 * kReach;
  Image part = filled_image(kWide, kWide, 0);
  for (std::uint32_t y = 0; y < kWide; ++y)
    for (std::uint32_t x = 0; x < kWide; ++x)
      part.values[y * kWide + x] = whole.values[(y + kFrom - kReach) * 70 + x + kFrom - kReach];
  const Image of_part = filled_ground(part, kReach);
  for (std::uint32_t y = kFrom; y < kTo; ++y)
    for (std::uint32_t x = kFrom; x < kTo; ++x)
      EXPECT_EQ(of_part.values[(y - kFrom + kReach) * kWide + x - kFrom + kReach], filled.values[y * 70 + x]);
}

}  // namespace
}  // namespace ilot
