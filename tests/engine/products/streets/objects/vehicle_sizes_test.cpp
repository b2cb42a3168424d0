// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/vehicle_sizes.h"

#include <gtest/gtest.h>

#include "engine/products/streets/objects/object_selection.h"

namespace ilot {
namespace {

constexpr double kPixel = 0.05;

ObjectCandidate sized(double length, double width) {
  ObjectCandidate c;
  c.length = length, c.width = width;
  return c;
}

TEST(VehicleSizes, WhatALawAllowsIsAVehicle) {
  EXPECT_FALSE(exceeds_vehicle(sized(18.7, 2.6), PointLabel::van, kPixel)) << "a road train";
  EXPECT_FALSE(exceeds_vehicle(sized(6.5, 3.1), PointLabel::van, kPixel)) << "with mirrors, and a pixel on both sides";
  EXPECT_TRUE(exceeds_vehicle(sized(16.8, 5.5), PointLabel::van, kPixel)) << "a terrace of a cafe";
  EXPECT_TRUE(exceeds_vehicle(sized(19, 2.5), PointLabel::van, kPixel));
  EXPECT_FALSE(exceeds_vehicle(sized(5.9, 2.2), PointLabel::car, kPixel));
  EXPECT_TRUE(exceeds_vehicle(sized(9.5, 2.2), PointLabel::car, kPixel)) << "two cars";
  EXPECT_FALSE(exceeds_vehicle(sized(9.5, 5), PointLabel::fence, kPixel)) << "other classes have no such limit";
}

// A van and a hedge that were joined are apart again, and a part that is too large is no van.
TEST(VehicleSizes, AJoinThatIsTooLargeIsCut) {
  std::vector<ObjectCandidate> candidates{sized(6, 2), sized(5, 1), sized(11.5, 4)};
  candidates[2].parts[0] = 1, candidates[2].parts[1] = 2;
  const CandidateClass van{PointLabel::van, 0.9, 0.9, 0.05, 0.05, 1}, hedge{PointLabel::vegetation, 0.9, 0.9, 0.9, 0.9};
  std::vector<CandidateClass> classes{van, hedge, van};
  EXPECT_EQ(select_objects(candidates, classes), (std::vector<std::uint8_t>{0, 0, 1}));
  deny_too_large_vehicles(candidates, {kPixel, 13}, classes);
  EXPECT_EQ(select_objects(candidates, classes), (std::vector<std::uint8_t>{1, 1, 0}));
  EXPECT_EQ(classes[0].label, PointLabel::van);
  EXPECT_EQ(classes[2].label, PointLabel::other);

  std::vector<ObjectCandidate> alone{sized(12, 5)};
  std::vector<CandidateClass> one{van};
  deny_too_large_vehicles(alone, {kPixel, 13, false}, one);
  EXPECT_EQ(one[0].label, PointLabel::van);
  deny_too_large_vehicles(alone, {kPixel, 13}, one);
  EXPECT_EQ(one[0].label, PointLabel::other);
  EXPECT_NEAR(one[0].probability, 1.0 / 13, 1e-12);
  EXPECT_EQ(select_objects(alone, one), std::vector<std::uint8_t>{1});
}

}  // namespace
}  // namespace ilot
