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

const ClassNames kFine{{10, "car"}, {13, "other"}, {14, "van"}, {18, "bin"}, {19, "bench"}};

// A bin that is called a bench is wrong among all classes and right among four; so is a van that is called a car.
TEST(Objects, JudgesAllClassesAndFourGroups) {
  const std::vector<TrueObject> truth{
      {1, "bin", 10, true}, {2, "van", 10, true}, {3, "van", 10, true}, {4, "car", 10, true}};
  const std::vector<LabelPair> pairs{{1, 51, 10}, {2, 52, 10}, {3, 53, 10}, {4, 0, 10}};
  const std::vector<LabelPair> labels{{51, 19, 10}, {52, 10, 10}, {53, 14, 10}};
  const ObjectResult r = evaluate_objects(truth, pairs, labels, kFine);
  EXPECT_NEAR(r.right_class.value(), 0.25, 1e-12);  // no bin, one van of two
  EXPECT_NEAR(r.right_group.value(), 1, 1e-12);
  ASSERT_EQ(r.classes.size(), 3u);
  EXPECT_EQ(r.classes[2].name, "van");
  EXPECT_EQ(r.classes[2].truth, 2u);
  EXPECT_EQ(r.classes[2].detected, 2u);
  EXPECT_EQ(r.classes[2].right, 1u);
  ASSERT_EQ(r.groups.size(), 2u);
  EXPECT_EQ(r.groups[0].name, "car");
  EXPECT_EQ(r.groups[0].truth, 3u);
  EXPECT_EQ(r.groups[0].right, 2u);
  EXPECT_FALSE(r.right_of_found.at(51));
}

TEST(Objects, TruthsOfEarlierVersionsHaveFourClasses) {
  const std::vector<TrueObject> truth{{1, "other", 10}, {2, "car", 10}, {3, "other", 10}};
  const std::vector<LabelPair> pairs{{1, 51, 10}, {2, 52, 10}, {3, 53, 10}};
  const std::vector<LabelPair> labels{{51, 18, 10}, {52, 14, 10}, {53, 10, 10}};
  const ObjectResult r = evaluate_objects(truth, pairs, labels, kFine);
  EXPECT_NEAR(r.right_class.value(), 0.75, 1e-12);  // the bin is one of the others, the last is no car
  EXPECT_EQ(r.right_class, r.right_group);
  EXPECT_EQ(r.confusion.classes, (std::vector<std::string>{"car", "other"}));
  EXPECT_TRUE(r.right_of_found.at(51));
  EXPECT_FALSE(r.right_of_found.at(53));
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
