// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/labels/confusion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ilot {
namespace {

using Counts = std::vector<std::vector<std::uint64_t>>;

int percent(std::optional<double> share) {
  return share ? static_cast<int>(std::lround(100 * *share)) : -1;
}

TEST(Confusion, CountsAHandMadeCase) {
  // Class 1 lies on segments 5 and 6, class 2 on 7, which also holds 30 of class 1; segment 8 holds clutter alone.
  const std::vector<LabelPair> pairs{{0, 8, 50}, {1, 0, 10}, {1, 5, 100}, {1, 6, 60},
                                     {1, 7, 30}, {2, 5, 4},  {2, 7, 80}};
  const ConfusionMatrix m = confusion_of_segments(pairs, {{1, "wall"}});
  EXPECT_EQ(m.classes, (std::vector<std::string>{"wall", "2"}));
  EXPECT_EQ(m.counts, (Counts{{160, 30, 10}, {4, 80, 0}}));
  EXPECT_DOUBLE_EQ(*precision(m, 0), 160.0 / 164);
  EXPECT_DOUBLE_EQ(*sensitivity(m, 0), 160.0 / 200);
  EXPECT_DOUBLE_EQ(*global_sensitivity(m), 240.0 / 284);
}

TEST(Confusion, SegmentsSpeakForTheSmallerClassInATie) {
  const ConfusionMatrix m = confusion_of_segments(std::vector<LabelPair>{{2, 1, 5}, {7, 1, 5}}, {});
  EXPECT_EQ(m.counts, (Counts{{5, 0, 0}, {5, 0, 0}}));
  EXPECT_FALSE(precision(m, 1).has_value());
}

TEST(Confusion, LabelsMeetByName) {
  const std::vector<LabelPair> pairs{{1, 0, 3}, {1, 4, 20}, {1, 9, 2}, {2, 4, 1}, {2, 5, 30}, {0, 5, 99}};
  const ConfusionMatrix m =
      confusion_of_labels(pairs, {{1, "ground"}, {2, "car"}}, {{4, "ground"}, {5, "car"}, {9, "tree"}});
  EXPECT_EQ(m.classes, (std::vector<std::string>{"ground", "car", "tree"}));
  EXPECT_EQ(m.counts, (Counts{{20, 0, 2, 3}, {1, 30, 0, 0}, {0, 0, 0, 0}}));
  EXPECT_FALSE(sensitivity(m, 2).has_value());
  EXPECT_EQ(*precision(m, 2), 0);
}

TEST(Confusion, TakesNothingAndAllUndetected) {
  EXPECT_FALSE(global_sensitivity(confusion_of_segments({}, {})).has_value());
  const ConfusionMatrix m = confusion_of_segments(std::vector<LabelPair>{{1, 0, 9}}, {});
  EXPECT_EQ(m.counts, (Counts{{0, 9}}));
  EXPECT_EQ(*global_sensitivity(m), 0);
  EXPECT_FALSE(precision(m, 0).has_value());
}

// Facing stones as Marchand's first table has them. Segments 1 to 4 are those it calls stones, joint, side 1, side 2.
TEST(Confusion, GivesTheTableOfEfficientRansac) {
  const std::vector<LabelPair> pairs{{1, 1, 38330}, {2, 1, 551}, {2, 2, 2024}, {3, 1, 636},
                                     {3, 3, 29386}, {4, 1, 402}, {4, 4, 2774}};
  const ConfusionMatrix m = confusion_of_segments(pairs, {{1, "stones"}, {2, "joint"}, {3, "side 1"}, {4, "side 2"}});
  const int precisions[] = {96, 100, 100, 100}, sensitivities[] = {100, 79, 98, 87};
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(percent(precision(m, c)), precisions[c]) << c;
    EXPECT_EQ(percent(sensitivity(m, c)), sensitivities[c]) << c;
  }
  EXPECT_EQ(percent(global_sensitivity(m)), 98);
}

// The same cloud by the document's own script.
TEST(Confusion, GivesTheTableOfDocumentA) {
  const std::vector<LabelPair> pairs{{1, 1, 38330}, {2, 1, 549}, {2, 2, 2026}, {3, 1, 869},
                                     {3, 3, 29153}, {4, 1, 293}, {4, 4, 2883}};
  const ConfusionMatrix m = confusion_of_segments(pairs, {});
  EXPECT_EQ(percent(global_sensitivity(m)), 98);
  EXPECT_EQ(percent(sensitivity(m, 1)), 79);
  EXPECT_EQ(percent(sensitivity(m, 3)), 91);
}

// Cloud 2: nothing on a wrong segment, much on none. The facade comes in two segments.
TEST(Confusion, GivesTheTableOfCloudTwo) {
  const std::vector<LabelPair> pairs{{1, 0, 8125}, {1, 1, 300000}, {1, 9, 99640}, {2, 0, 3898}, {2, 2, 3626},
                                     {3, 0, 3335}, {3, 3, 70349},  {4, 0, 13226}, {4, 4, 82524}};
  const ConfusionMatrix m = confusion_of_segments(pairs, {});
  const int sensitivities[] = {98, 48, 95, 86};
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(percent(precision(m, c)), 100) << c;
    EXPECT_EQ(percent(sensitivity(m, c)), sensitivities[c]) << c;
  }
  EXPECT_EQ(percent(global_sensitivity(m)), 95);
}

}  // namespace
}  // namespace ilot
