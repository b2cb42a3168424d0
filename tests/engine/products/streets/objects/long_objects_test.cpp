// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/long_objects.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

// `standing`: the length of what of it is lower than 30 cm.
ObjectCandidate strip(double length, double width, double standing) {
  ObjectCandidate c;
  c.length = length, c.width = width;
  c.features[static_cast<std::size_t>(CandidateFeature::band_length)] = standing;
  return c;
}

TEST(LongObjects, AFenceStandsOnTheGroundOverItsLength) {
  EXPECT_TRUE(is_strip_on_ground(strip(25, 0.2, 24), 0.05)) << "a fence";
  EXPECT_TRUE(is_strip_on_ground(strip(25, 1.5, 20), 0.05)) << "a hedge with a gate";
  EXPECT_FALSE(is_strip_on_ground(strip(36, 0.1, 0.5), 0.05)) << "a wire and its pole";
  EXPECT_FALSE(is_strip_on_ground(strip(25, 1.9, 24), 0.05)) << "cars in a row";
}

TEST(LongObjects, OnlyWhatIsTooLongBecomesAFence) {
  const std::vector<ObjectCandidate> candidates{strip(25, 0.4, 24), strip(19, 0.4, 18), strip(25, 0.4, 24),
                                                strip(30, 0.1, 1)};
  std::vector<CandidateClass> classes(4, {PointLabel::other, 0.6, 0.9, 0.05, 0.05, 1});
  classes[2].label = PointLabel::vegetation;
  name_long_strips(candidates, 0.05, classes);
  EXPECT_EQ(classes[0].label, PointLabel::fence);
  EXPECT_EQ(classes[1].label, PointLabel::other);
  EXPECT_EQ(classes[2].label, PointLabel::vegetation) << "a hedge";
  EXPECT_EQ(classes[3].label, PointLabel::other) << "a wire";
}

}  // namespace
}  // namespace ilot
