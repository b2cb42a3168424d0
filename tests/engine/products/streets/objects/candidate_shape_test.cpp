// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_shape.h"

#include <gtest/gtest.h>

#include <functional>

namespace ilot {
namespace {

constexpr std::uint32_t kSide = 60;

struct PixelForm {
  Height height = kNoHeight;
  Height bins = 0;
};
using FormAt = std::function<PixelForm(std::uint32_t x, std::uint32_t y)>;  // kNoHeight: not of the candidate

// Describes the candidate whose pixels `at` gives.
ObjectCandidate shaped(const FormAt& at) {
  Patch patch;
  patch.x = 100, patch.y = -40;
  for (Image* image : {&patch.height, &patch.range, &patch.accumulation, &patch.above, &patch.low, &patch.occupancy,
                       &patch.components, &patch.beside})
    *image = filled_image(kSide, kSide, 0);
  ComponentImages images{patch, filled_image(kSide, kSide, kNoHeight), filled_image(kSide, kSide, 0)};
  PixelLabels labels{kSide, kSide, 1, std::vector<std::uint32_t>(kSide * kSide, 0)};
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const PixelForm f = at(x, y);
      if (f.height == kNoHeight) continue;
      const std::size_t i = std::size_t{y} * kSide + x;
      labels.of[i] = 1, images.own.values[i] = f.height, patch.occupancy.values[i] = f.bins;
      patch.accumulation.values[i] = patch.above.values[i] = patch.low.values[i] = 1;
    }
  return describe(labels, images, {}, {}).at(0);
}

double of(const ObjectCandidate& c, CandidateFeature f) {
  return c.features[static_cast<std::size_t>(f)];
}

// A roof 40 pixels long and 20 wide that rises along its length.
PixelForm leaning_box(std::uint32_t x, std::uint32_t y) {
  if (x < 10 || x >= 50 || y < 20 || y >= 40) return {};
  return {static_cast<Height>(1000 + 10 * (x - 10)), 0b1111};
}

TEST(CandidateShape, OfALeaningBox) {
  const RasterScale scale;
  const ObjectCandidate c = shaped(leaning_box);
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
  const ObjectCandidate c = shaped([](std::uint32_t x, std::uint32_t y) {
    if (leaning_box(x, y).height == kNoHeight) return PixelForm{};
    return PixelForm{x >= 20 && x < 40 ? 1500 : 900, 0};
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
  const ObjectCandidate c = shaped([&](std::uint32_t x, std::uint32_t y) {
    if (x < 20 || x >= 40 || y < 30 || y >= 32) return PixelForm{};
    return PixelForm{top, x >= 29 && x < 31 ? 0b111111111 : 0b111000000};
  });
  EXPECT_NEAR(of(c, CandidateFeature::foot_share), 0.1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::waist_share), 0.1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::head_share), 1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::solid_share), (0.1 * 9 + 0.9 * 3) / 9, 1e-9);
  EXPECT_LT(of(c, CandidateFeature::foot_length), 0.15 * of(c, CandidateFeature::box_length));
}

TEST(CandidateShape, DoesNotDependOnTheDirection) {
  const ObjectCandidate a = shaped(leaning_box),
                        b = shaped([](std::uint32_t x, std::uint32_t y) { return leaning_box(y, x); }),
                        c = shaped(
                            [](std::uint32_t x, std::uint32_t y) { return leaning_box(kSide - 1 - x, kSide - 1 - y); });
  for (auto f = static_cast<std::size_t>(CandidateFeature::box_length); f < kCandidateFeatures; ++f) {
    EXPECT_NEAR(a.features[f], b.features[f], 1e-9) << candidate_feature_name(f);
    EXPECT_NEAR(a.features[f], c.features[f], 1e-9) << candidate_feature_name(f);
  }
}

}  // namespace
}  // namespace ilot
