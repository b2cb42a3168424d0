// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/occupancy.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

std::vector<Occupancy> free_bins_by_hand(std::span<const Occupancy> image, int width, int height,
                                         const PixelRing& ring) {
  const auto inner = static_cast<int>(ring.within), reach = static_cast<int>(ring.reach);
  std::vector<Occupancy> out(image.begin(), image.end());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int v = std::max(0, y - reach); v <= std::min(height - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(width - 1, x + reach); ++u)
          if (std::max(std::abs(u - x), std::abs(v - y)) > inner)
            out[static_cast<std::size_t>(y * width + x)] &= ~image[static_cast<std::size_t>(v * width + u)];
  return out;
}

std::vector<Occupancy> drawn(Rng& rng, std::size_t pixels, std::uint32_t one_in) {
  std::vector<Occupancy> image(pixels, 0);
  for (Occupancy& v : image)
    if (rng.below(one_in) == 0) v = static_cast<Occupancy>(rng.below(std::uint64_t{1} << kOccupancyBins));
  return image;
}

// A post of two pixels beside a hedge: free above it.
TEST(Occupancy, APostIsFreeAboveTheHedgeItStandsIn) {
  std::vector<Occupancy> image(9 * 5, 0);
  for (std::size_t x = 3; x < 9; ++x) image[2 * 9 + x] = 0b0011;
  image[2 * 9 + 2] = image[2 * 9 + 3] = 0b1111;
  const auto free = free_bins(image, 9, 5, {1, 3});
  EXPECT_EQ(free[2 * 9 + 2], 0b1100u);
  EXPECT_EQ(free[2 * 9 + 3], 0b1100u);
  EXPECT_EQ(free[2 * 9 + 5], 0u);
  EXPECT_EQ(free[0], 0u);
}

TEST(Occupancy, FreeBinsAreThoseOfBruteForce) {
  Rng rng(7);
  for (const PixelRing ring : {PixelRing{0, 1}, {0, 3}, {1, 2}, {2, 5}, {4, 7}, {3, 20}})
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {8, 1}, {17, 23}, {40, 7}})
      for (const std::uint32_t one_in : {1u, 6u, 40u}) {
        const auto image = drawn(rng, static_cast<std::size_t>(width * height), one_in);
        EXPECT_EQ(free_bins(image, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), ring),
                  free_bins_by_hand(image, width, height, ring))
            << width << " x " << height << ", " << ring.within << " to " << ring.reach;
      }
}

// Each bin by itself: words of many bins are many images of one.
TEST(Occupancy, BinsDoNotSeeEachOther) {
  Rng rng(8);
  const auto image = drawn(rng, 30 * 20, 5);
  const auto together = free_bins(image, 30, 20, {2, 4});
  for (std::uint32_t bin = 0; bin < kOccupancyBins; ++bin) {
    std::vector<Occupancy> plane(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) plane[i] = image[i] >> bin & 1;
    const auto free = free_bins(plane, 30, 20, {2, 4});
    for (std::size_t i = 0; i < image.size(); ++i) ASSERT_EQ(free[i], together[i] >> bin & 1) << bin << ", " << i;
  }
}

TEST(Occupancy, NothingIsFreeOfNothing) {
  EXPECT_TRUE(free_bins({}, 0, 0, {1, 2}).empty());
  const std::vector<Occupancy> none(12, 0);
  EXPECT_EQ(free_bins(none, 4, 3, {5, 9}), none);
}

TEST(Occupancy, LongestRunIsTheLowestOfTheLongest) {
  const auto run = [](Occupancy bins) {
    const BinRun r = longest_run(bins);
    return std::pair{r.first, r.length};
  };
  EXPECT_EQ(run(0), (std::pair{0u, 0u}));
  EXPECT_EQ(run(1), (std::pair{0u, 1u}));
  EXPECT_EQ(run(0b0110'0110), (std::pair{1u, 2u}));
  EXPECT_EQ(run(0b1110'0110), (std::pair{5u, 3u}));
  EXPECT_EQ(run(0x7fffffff), (std::pair{0u, 31u}));
  EXPECT_EQ(longest_run(0b1110'0110).bins(), 0b1110'0000u);
  Rng rng(9);
  for (int i = 0; i < 1000; ++i) {
    const auto bins = static_cast<Occupancy>(rng.below(std::uint64_t{1} << kOccupancyBins));
    const BinRun r = longest_run(bins);
    EXPECT_EQ(bins & r.bins(), r.bins());
    Occupancy longer = bins;  // a bit is left where a run of one more begins
    for (std::uint32_t k = 0; k < r.length; ++k) longer &= bins >> (k + 1);
    EXPECT_EQ(longer, 0u);
  }
}

}  // namespace
}  // namespace ilot
