// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_bands.h"

#include <gtest/gtest.h>

#include "tests/support/drawn_candidate.h"

namespace ilot {
namespace {

constexpr Height kCarTop = 1600;
constexpr Height kUpTo60 = 0b111111, kUpTo160 = 0xFFFF;  // centimetres; bins of 10

double band(const ObjectCandidate& c, CandidateFeature first, std::size_t number) {
  return c.features[static_cast<std::size_t>(first) + number];
}

// A body of 40 by 16 pixels, with a cabin over half of its length from `cabin` on.
DrawnPixel car(std::uint32_t x, std::uint32_t y, std::uint32_t cabin) {
  if (x < 10 || x >= 50 || y < 20 || y >= 36) return {};
  return x >= cabin && x < cabin + 20 ? DrawnPixel{kCarTop, kUpTo160} : DrawnPixel{600, kUpTo60};
}

TEST(CandidateBands, ACabinIsShorterThanTheBodyBelowIt) {
  const RasterScale scale;
  const ObjectCandidate c = drawn_candidate([](std::uint32_t x, std::uint32_t y) { return car(x, y, 30); });
  for (const std::size_t low : {0, 1}) {
    EXPECT_EQ(band(c, CandidateFeature::band_share, low), 1);
    EXPECT_NEAR(band(c, CandidateFeature::band_length, low), 40 * scale.pixel, 1e-9);
    EXPECT_NEAR(band(c, CandidateFeature::band_width, low), 16 * scale.pixel, 1e-9);
    EXPECT_NEAR(band(c, CandidateFeature::band_offset, low), 0, 1e-9);
  }
  for (const std::size_t high : {2, 3, 4}) {  // up to 1.0, 1.4 and 1.8 m
    EXPECT_EQ(band(c, CandidateFeature::band_share, high), 0.5);
    EXPECT_NEAR(band(c, CandidateFeature::band_length, high), 20 * scale.pixel, 1e-9);
    EXPECT_NEAR(band(c, CandidateFeature::band_width, high), 16 * scale.pixel, 1e-9);
    EXPECT_NEAR(band(c, CandidateFeature::band_offset, high), 10 * scale.pixel, 1e-9);
  }
  for (const std::size_t above : {5, 6})
    for (const CandidateFeature f : {CandidateFeature::band_share, CandidateFeature::band_length,
                                     CandidateFeature::band_width, CandidateFeature::band_offset})
      EXPECT_EQ(band(c, f, above), 0);
  // Of 40 * 15 pairs across and 39 * 16 along, 16 go up to the cabin.
  const double pairs = 40 * 15 + 39 * 16;
  EXPECT_NEAR(of(c, CandidateFeature::level_share), (pairs - 16) / pairs, 1e-12);
  EXPECT_NEAR(of(c, CandidateFeature::step_share), 16 / pairs, 1e-12);
}

TEST(CandidateBands, DoNotDependOnTheDirection) {
  const ObjectCandidate c = drawn_candidate([](std::uint32_t x, std::uint32_t y) { return car(x, y, 15); });
  const ObjectCandidate across = drawn_candidate([](std::uint32_t x, std::uint32_t y) { return car(y, x, 15); });
  const ObjectCandidate back =
      drawn_candidate([](std::uint32_t x, std::uint32_t y) { return car(kDrawnSide - 1 - x, y, 15); });
  for (auto f = static_cast<std::size_t>(CandidateFeature::band_share); f < kCandidateFeatures; ++f) {
    EXPECT_NEAR(across.features[f], c.features[f], 1e-9) << candidate_feature_name(f);
    EXPECT_NEAR(back.features[f], c.features[f], 1e-9) << candidate_feature_name(f);
  }
}

// Points of a crown are a metre and more above it.
TEST(CandidateBands, OwnTopIsBelowTheCrown) {
  constexpr Height kCrown = 0x38000000;  // from 2.7 m on
  const auto below = [](Height of_crown) {
    return drawn_candidate([=](std::uint32_t x, std::uint32_t y) {
      DrawnPixel p = car(x, y, 30);
      if (p.height != kNoHeight && x > 40) p = {6000, p.bins | of_crown};
      return p;
    });
  };
  EXPECT_NEAR(below(kCrown).own_top, 1.6, 1e-9);
  EXPECT_NEAR(below(kCrown | 0x01000000).own_top, 6, 1e-9);  // a point at 2.4 m: no metre is free
  EXPECT_NEAR(drawn_candidate([](std::uint32_t x, std::uint32_t y) { return car(x, y, 30); }).own_top, 1.6, 1e-9);
}

TEST(CandidateBands, LeavesGoUpAndDown) {
  const ObjectCandidate leaves = drawn_candidate([](std::uint32_t x, std::uint32_t y) {
    return x >= 20 && x < 40 && y >= 20 && y < 40 ? DrawnPixel{static_cast<Height>(200 * ((7 * x + 3 * y) % 8)), 1}
                                                  : DrawnPixel{};
  });
  EXPECT_LT(of(leaves, CandidateFeature::level_share), 0.2);
  EXPECT_GT(of(leaves, CandidateFeature::step_share), 0.8);
}

}  // namespace
}  // namespace ilot
