// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/labels/objects.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

const ClassNames kLabels{{10, "car"}, {11, "lamppost"}, {12, "pedestrian"}};

TEST(Objects, CountsAHandMadeStreet) {
  const std::vector<TrueObject> truth{{1, "car", 100},       {2, "car", 100},     {3, "pedestrian", 20},
                                      {4, "pedestrian", 20}, {5, "lamppost", 30}, {6, "lamppost", 0}};
  const std::vector<LabelPair> pairs{{0, 70, 40},                           // found where nothing is
                                     {1, 0, 10},  {1, 50, 90},              // most of car 1
                                     {2, 0, 60},  {2, 51, 40},              // less than half of car 2
                                     {3, 52, 20}, {4, 52, 18}, {4, 53, 2},  // two pedestrians in one
                                     {5, 54, 30}};
  const std::vector<LabelPair> labels{{50, 10, 60}, {50, 12, 30}, {51, 10, 40}, {52, 0, 20},
                                      {52, 11, 18}, {53, 12, 2},  {54, 0, 30},  {70, 10, 40}};
  const ObjectResult r = evaluate_objects(truth, pairs, labels, kLabels);
  EXPECT_EQ(r.truth, 5u);
  EXPECT_EQ(r.unseen, 1u);
  EXPECT_EQ(r.found, 6u);
  EXPECT_EQ(r.detected, 3u);
  EXPECT_EQ(r.false_found, 3u);
  const std::vector<std::string> classes{"car", "lamppost", "pedestrian", "unlabelled"};
  EXPECT_EQ(r.confusion.classes, classes);
  const std::vector<std::vector<std::uint64_t>> counts{
      {1, 0, 0, 0, 1}, {0, 0, 0, 1, 0}, {0, 1, 0, 0, 1}, {0, 0, 0, 0, 0}};
  EXPECT_EQ(r.confusion.counts, counts);
  // Of the detected: the car is right, the pedestrian is not, the lamppost has no label. Of all: half of the cars.
  EXPECT_NEAR(r.right_class.value(), 1.0 / 3, 1e-12);
  EXPECT_NEAR(r.detected_and_right.value(), 0.5 / 3, 1e-12);
  EXPECT_EQ(r.right_of_found, (std::map<std::uint32_t, bool>{
                                  {50, true}, {51, false}, {52, false}, {53, false}, {54, false}, {70, false}}));
}

TEST(Objects, OtherIsRightForClassesThatTheProductDoesNotKnow) {
  const ClassNames labels{{10, "car"}, {13, "other"}};
  const std::vector<TrueObject> truth{{1, "kiosk", 10}, {2, "dog", 10}};
  const std::vector<LabelPair> pairs{{1, 50, 10}, {2, 51, 10}};
  const ObjectResult r = evaluate_objects(truth, pairs, std::vector<LabelPair>{{50, 13, 10}, {51, 10, 10}}, labels);
  EXPECT_NEAR(r.right_class.value(), 0.5, 1e-12);
  EXPECT_TRUE(r.right_of_found.at(50));
  EXPECT_FALSE(r.right_of_found.at(51));
}

TEST(Objects, HalfOfBothTogetherIsEnough) {
  const std::vector<TrueObject> truth{{1, "car", 10}};
  const auto detected = [&](std::uint64_t common) {
    return evaluate_objects(truth, std::vector<LabelPair>{{0, 5, 10 - common}, {1, 0, 10}, {1, 5, common}}, {}, kLabels)
        .detected;
  };
  EXPECT_EQ(detected(9), 0u);   // 9 of 20
  EXPECT_EQ(detected(10), 1u);  // 10 of 20
}

TEST(Objects, NothingOnEitherSide) {
  const ObjectResult none = evaluate_objects({}, {}, {}, kLabels);
  EXPECT_EQ(none.truth + none.found + none.detected + none.false_found, 0u);
  const std::vector<TrueObject> truth{{1, "car", 10}};
  const ObjectResult missed = evaluate_objects(truth, std::vector<LabelPair>{{1, 0, 10}}, {}, kLabels);
  EXPECT_EQ(missed.truth, 1u);
  EXPECT_EQ(missed.detected, 0u);
  EXPECT_EQ(missed.confusion.counts.at(0).back(), 1u);
}

}  // namespace
}  // namespace ilot
