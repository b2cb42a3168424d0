// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/ground_surface.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// A slope of 10% with two buildings on it, holes in the data, and a pit.
Image hillside(std::uint32_t side) {
  Rng rng(3);
  Image image = filled_image(side, side, 0);
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      Height& v = image.values[std::size_t{y} * side + x];
      v = static_cast<Height>(100 * x + rng.below(50));
      if (x >= 20 && x < 32 && y >= 20 && y < 40) v += 6000;   // a house
      if (x >= 60 && x < 100 && y >= 50 && y < 90) v += 9000;  // a hall of 40 m
      if (x >= 40 && x < 50 && y >= 5 && y < 12) v = kNoHeight;
    }
  }
  return image;
}

TEST(GroundSurface, BuildingsDisappearAndTheSlopeStays) {
  constexpr std::uint32_t kGroundSide = 160;
  const Image ground = ground_surface(hillside(kGroundSide));
  for (std::uint32_t y = 30; y < 130; ++y)
    for (std::uint32_t x = 15; x < 145; ++x)
      EXPECT_NEAR(ground.values[std::size_t{y} * kGroundSide + x], 100 * x, 2600) << x << " " << y;
  EXPECT_LT(ground.values[std::size_t{30} * kGroundSide + 26], 100 * 26 + 1500) << "under the house";
  EXPECT_NEAR(ground.values[std::size_t{120} * kGroundSide + 120], 100 * 120, 60) << "bare ground is as it was";
  EXPECT_NE(ground.values[std::size_t{8} * kGroundSide + 45], kNoHeight) << "water is filled from around";
}

TEST(GroundSurface, PartsWithTheirHaloGiveTheWhole) {
  constexpr std::uint32_t kGroundSide = 300, kFrom = 130, kTo = 160;
  const Image whole = hillside(kGroundSide), ground = ground_surface(whole);
  constexpr std::uint32_t kPart = kTo - kFrom + 2 * kGroundHalo;
  Image part = filled_image(kPart, kPart, kNoHeight);
  const std::uint32_t low = kFrom - kGroundHalo;
  for (std::uint32_t y = 0; y < kPart; ++y)
    for (std::uint32_t x = 0; x < kPart; ++x)
      part.values[std::size_t{y} * kPart + x] = whole.values[std::size_t{y + low} * kGroundSide + x + low];
  const Image found = ground_surface(part);
  for (std::uint32_t y = kFrom; y < kTo; ++y)
    for (std::uint32_t x = kFrom; x < kTo; ++x)
      ASSERT_EQ(found.values[std::size_t{y - low} * kPart + x - low], ground.values[std::size_t{y} * kGroundSide + x]);
}

TEST(GroundSurface, NothingGivesNothing) {
  EXPECT_TRUE(ground_surface({}).values.empty());
  for (const Height v : ground_surface(filled_image(5, 4, kNoHeight)).values) EXPECT_EQ(v, kNoHeight);
}

}  // namespace
}  // namespace ilot
