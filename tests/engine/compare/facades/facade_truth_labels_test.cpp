// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/facade_truth_labels.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TEST(FacadeTruthLabels, AnElementSpeaksBeforeItsSurface) {
  Truth truth;
  truth.classes = {{0, "mixed"}, {1, "facade"}, {2, "wall"}, {3, "moulding"}, {4, "ground"}, {5, "other"}};
  for (const auto& [id, kind] : std::map<std::uint32_t, std::string>{
           {1, "window"}, {2, "shop"}, {3, "sill"}, {4, "cornice"}, {5, "balcony"}, {6, "car"}})
    truth.elements.push_back({id, 1, kind, 0, 0, {}, 0, 0, 0});
  const FacadeTruthLabels words = facade_truth_labels(truth);
  EXPECT_EQ(words.of(2, 1), PointLabel::window) << "a reveal";
  EXPECT_EQ(words.of(5, 2), PointLabel::door);
  EXPECT_EQ(words.of(1, 3), PointLabel::sill);
  EXPECT_EQ(words.of(5, 4), PointLabel::facade) << "a cornice has no word of its own";
  EXPECT_EQ(words.of(3, 5), PointLabel::balcony);
  EXPECT_EQ(words.of(5, 6), PointLabel::other);
  EXPECT_EQ(words.of(1, 0), PointLabel::facade);
  EXPECT_EQ(words.of(3, 0), PointLabel::facade) << "a moulding of no element";
  EXPECT_EQ(words.of(2, 0), PointLabel::other) << "a wall that is no facade";
  EXPECT_EQ(words.of(4, 0), PointLabel::other);
  EXPECT_EQ(words.of(0, 1), PointLabel::none) << "mixed pixels are not judged";
}

}  // namespace
}  // namespace ilot
