// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_bins.h"

#include <gtest/gtest.h>

#include "tests/support/drawn_candidate.h"

namespace ilot {
namespace {

constexpr Height kTall = 2000;

TEST(CandidateBins, APostIsALineThatStands) {
  const ObjectCandidate c = drawn_candidate([](std::uint32_t x, std::uint32_t y) {
    return x == 30 && y == 30 ? DrawnPixel{kTall, 0b1111111111} : DrawnPixel{};
  });
  EXPECT_NEAR(of(c, CandidateFeature::linear), 1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::planar), 0, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::upright_axis), 1, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::thickness), 0, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::neighbour_bins), 2 * 9 / 10.0, 1e-9);  // the ends have one neighbour
}

TEST(CandidateBins, AFenceIsASheetWithALevelNormal) {
  const RasterScale scale;
  const ObjectCandidate c = drawn_candidate([](std::uint32_t x, std::uint32_t y) {
    return y == 30 && x >= 10 && x < 50 ? DrawnPixel{kTall, 0b1111111000} : DrawnPixel{};
  });
  EXPECT_GT(of(c, CandidateFeature::planar), 0.05);
  EXPECT_NEAR(of(c, CandidateFeature::upright_axis), 0, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::level_normal), 0, 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::lowest_bin), 3 * scale.bin(), 1e-9);
  EXPECT_NEAR(of(c, CandidateFeature::thickness), 0, 1e-9);
  // 40 by 7 bins: all pairs of neighbours in a grid, counted from both sides.
  EXPECT_NEAR(of(c, CandidateFeature::neighbour_bins), 2.0 * (40 * 6 + 39 * 7 + 2 * 39 * 6) / (40 * 7), 1e-9);
}

TEST(CandidateBins, LeavesHaveFewerNeighboursThanABox) {
  const auto in_square = [](std::uint32_t x, std::uint32_t y) { return x >= 20 && x < 40 && y >= 20 && y < 40; };
  const ObjectCandidate box = drawn_candidate([&](std::uint32_t x, std::uint32_t y) {
    return in_square(x, y) ? DrawnPixel{kTall, 0b11111111} : DrawnPixel{};
  });
  const ObjectCandidate leaves = drawn_candidate([&](std::uint32_t x, std::uint32_t y) {
    return in_square(x, y) ? DrawnPixel{kTall, 1 << ((7 * x + 3 * y) % 8)} : DrawnPixel{};
  });
  EXPECT_LT(of(leaves, CandidateFeature::neighbour_bins), of(box, CandidateFeature::neighbour_bins) / 3);
}

TEST(CandidateBins, NothingIsKnownWithNoOccupancy) {
  const ObjectCandidate c = drawn_candidate([](std::uint32_t x, std::uint32_t y) {
    return x >= 20 && x < 40 && y >= 20 && y < 40 ? DrawnPixel{kTall, 0} : DrawnPixel{};
  });
  for (auto f = static_cast<std::size_t>(CandidateFeature::neighbour_bins);
       f < static_cast<std::size_t>(CandidateFeature::band_share); ++f)
    EXPECT_EQ(c.features[f], 0) << candidate_feature_name(f);
}

}  // namespace
}  // namespace ilot
