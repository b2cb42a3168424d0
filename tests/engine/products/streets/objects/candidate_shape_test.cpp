// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_shape.h"

#include <gtest/gtest.h>

#include "tests/support/drawn_candidate.h"

namespace ilot {
namespace {

// A roof 40 pixels long and 20 wide that rises along its length.
DrawnPixel leaning_box(std::uint32_t x, std::uint32_t y) {
  if (x < 10 || x >= 50 || y < 20 || y >= 40) return {};
  return {static_cast<Height>(1000 + 10 * (x - 10)), 0b1111};
}

TEST(CandidateShape, OfALeaningBox) {
  const RasterScale scale;
  const ObjectCandidate c = drawn_candidate(leaning_box);
  EXPECT_NEAR(of(c, CandidateFeature::box_length), 40 * scale.pixel, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::box_width), 20 * scale.pixel, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::box_fill), 1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::unevenness), 0, 1e-6);
  EXPECT_NEAR(of(c, CandidateFeature::half_share), 1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::ends_height), 1, 0.01);
  EXPECT_NEAR(of(c, CandidateFeature::foot_share), 1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::foot_length), c.length, 1e-9);
}

TEST(CandidateShape, ABonnetLowersTheEnds) {
  const ObjectCandidate c = drawn_candidate([](std::uint32_t x, std::uint32_t y) {
    if (leaning_box(x, y).height == kNoHeight) return DrawnPixel{};
    return DrawnPixel{x >= 20 && x < 40 ? 1500 : 900, 0};
  });
  EXPECT_NEAR(of(c, CandidateFeature::ends_height), 0.6, 0.01);
  EXPECT_NEAR(of(c, CandidateFeature::sides_height), 1, 0.01);
  EXPECT_NEAR(of(c, CandidateFeature::high_share), 0.5, 1e-9);
  EXPECT_GT(of(c, CandidateFeature::unevenness), 0.2);
  EXPECT_EQ(of(c, CandidateFeature::foot_share), 0);  // with no occupancy
}

// A plate of 20 pixels on a post of 2: the foot is thin, the head is wide.
TEST(CandidateShape, OfAPlateOnAPost) {
  const RasterScale scale;
  const Height top = scale.units(9 * scale.bin());  // nine bins
  const ObjectCandidate c = drawn_candidate([&](std::uint32_t x, std::uint32_t y) {
    if (x < 20 || x >= 40 || y < 30 || y >= 32) return DrawnPixel{};
    return DrawnPixel{top, x >= 29 && x < 31 ? 0b111111111 : 0b111000000};
  });
  EXPECT_NEAR(of(c, CandidateFeature::foot_share), 0.1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::waist_share), 0.1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::head_share), 1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::solid_share), (0.1 * 9 + 0.9 * 3) / 9, 1e-9);
  EXPECT_LT(of(c, CandidateFeature::foot_length), 0.15 * of(c, CandidateFeature::box_length));
}

TEST(CandidateShape, DoesNotDependOnTheDirection) {
  const ObjectCandidate a = drawn_candidate(leaning_box),
                        b = drawn_candidate([](std::uint32_t x, std::uint32_t y) { return leaning_box(y, x); }),
                        c = drawn_candidate([](std::uint32_t x, std::uint32_t y) {
                          return leaning_box(kDrawnSide - 1 - x, kDrawnSide - 1 - y);
                        });
  for (auto f = static_cast<std::size_t>(CandidateFeature::box_length); f < kCandidateFeatures; ++f) {
    EXPECT_NEAR(a.features[f], b.features[f], 1e-9) << candidate_feature_name(f);
    EXPECT_NEAR(a.features[f], c.features[f], 1e-9) << candidate_feature_name(f);
  }
}

}  // namespace
}  // namespace ilot
