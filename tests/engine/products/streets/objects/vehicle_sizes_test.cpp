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

// `level` and `step`: the shares of pixels side by side that are level, or jump.
ObjectCandidate seen(double height, double box_fill, double level, double step) {
  ObjectCandidate c = sized(3.5, 1.8);
  const auto set = [&](auto which, double v) { c.features[static_cast<std::size_t>(which)] = v; };
  set(ComponentFeature::max_height, height), set(CandidateFeature::box_fill, box_fill);
  set(CandidateFeature::pixel_size, kPixel);
  set(CandidateFeature::level_share, level), set(CandidateFeature::step_share, step);
  return c;
}

TEST(VehicleSizes, ARackOfBicyclesHasGaps) {
  EXPECT_TRUE(is_rough_vehicle(seen(1.6, 0.5, 0.4, 0.3), PointLabel::car)) << "a rack of bicycles";
  EXPECT_TRUE(is_rough_vehicle(seen(1.6, 0.5, 0.4, 0.3), PointLabel::van));
  EXPECT_FALSE(is_rough_vehicle(seen(1.5, 0.6, 0.7, 0.14), PointLabel::car)) << "a car";
  EXPECT_FALSE(is_rough_vehicle(seen(1.5, 0.2, 0.2, 0.5), PointLabel::car)) << "one of which a side was seen";
  EXPECT_FALSE(is_rough_vehicle(seen(3.2, 0.6, 0.5, 0.4), PointLabel::van)) << "higher than the scanner";
  EXPECT_FALSE(is_rough_vehicle(seen(1.6, 0.5, 0.4, 0.3), PointLabel::planter));
  ObjectCandidate sparse = seen(1.6, 0.5, 0.4, 0.3);
  sparse.features[static_cast<std::size_t>(CandidateFeature::pixel_size)] = 0.1;
  EXPECT_FALSE(is_rough_vehicle(sparse, PointLabel::car)) << "pixels are too coarse for gaps";
}

// What has gaps is called as what comes next, where these are two-wheelers.
TEST(VehicleSizes, WhatHasGapsIsNoVehicle) {
  const std::vector<ObjectCandidate> candidates(2, seen(1.6, 0.5, 0.4, 0.3));
  std::vector<CandidateClass> classes(2, {PointLabel::car, 0.9, 0.9, 0.05, 0.05, 1});
  classes[0].next = PointLabel::two_wheeler, classes[0].next_probability = 0.1;
  classes[1].next = PointLabel::planter, classes[1].next_probability = 0.1;
  deny_rough_vehicles(candidates, 13, classes);
  EXPECT_EQ(classes[0].label, PointLabel::two_wheeler);
  EXPECT_EQ(classes[0].probability, 0.1);
  EXPECT_EQ(classes[1].label, PointLabel::other);
  EXPECT_NEAR(classes[1].probability, 1.0 / 13, 1e-12);
  EXPECT_EQ(select_objects(candidates, classes), (std::vector<std::uint8_t>{1, 1})) << "they are found as before";
}

}  // namespace
}  // namespace ilot
