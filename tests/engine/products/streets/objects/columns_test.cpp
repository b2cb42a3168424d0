// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/columns.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/products/streets/objects/part_contacts.h"
#include "engine/products/streets/objects/part_joins.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

constexpr std::uint32_t kWidth = 60, kHeight = 40;
constexpr Occupancy kLowBins = 0b11'1110, kHighBins = 0b11'1111'1111'1100'0000;  // 10 to 60 cm, and on to 1.8 m

// Pixels of 5 cm and bins of 10.
struct Street {
  std::vector<Occupancy> occupancy = std::vector<Occupancy>(kWidth * kHeight, 0);
  PixelLabels parts{kWidth, kHeight, 0, std::vector<std::uint32_t>(kWidth* kHeight, 0)};

  void add_box(const test::PixelBox& box, Occupancy bins, std::uint32_t part) {
    for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
      for (std::uint32_t x = box.x; x < box.x + box.width; ++x) {
        occupancy[y * kWidth + x] |= bins;
        parts.of[y * kWidth + x] = part;
      }
    parts.count = std::max(parts.count, part);
  }
  PixelLabels columns() const { return columns_of(occupancy, kWidth, kHeight, {}); }
  std::size_t pixels_of(const PixelLabels& labels, std::uint32_t label) const {
    return static_cast<std::size_t>(std::count(labels.of.begin(), labels.of.end(), label));
  }
};

Street post_in_a_hedge() {
  Street s;
  s.add_box({5, 10, 40, 14}, kLowBins, 1);
  s.add_box({20, 15, 3, 3}, kLowBins | kHighBins, 1);
  return s;
}

TEST(Columns, APostInAHedgeIsOne) {
  const Street s = post_in_a_hedge();
  const PixelLabels columns = s.columns();
  ASSERT_EQ(columns.count, 1u);
  EXPECT_EQ(s.pixels_of(columns, 1), 9u);
  EXPECT_EQ(columns.of[15 * kWidth + 20], 1u);
}

TEST(Columns, NeitherAHedgeNorAWallNorWhatIsLowIsOne) {
  Street hedge, wall, stub, beside;
  hedge.add_box({5, 10, 40, 14}, kLowBins, 1);
  wall.add_box({5, 10, 40, 2}, kLowBins | kHighBins, 1);
  stub.add_box({20, 15, 3, 3}, kLowBins >> 1 & kLowBins, 1);  // free over 40 cm
  beside.add_box({20, 15, 3, 3}, kLowBins | kHighBins, 1);
  beside.add_box({31, 15, 10, 3}, kLowBins | kHighBins, 1);  // 40 cm away, as high
  for (const Street& s : {hedge, wall, stub, beside}) EXPECT_EQ(s.columns().count, 0u);
}

TEST(Columns, UnderACrownTheTrunkIsFree) {
  Street s;
  s.add_box({5, 5, 30, 30}, Occupancy{0b111} << 25, 1);
  s.add_box({18, 18, 5, 5}, kLowBins | kHighBins, 1);
  EXPECT_EQ(s.pixels_of(s.columns(), 1), 25u);
}

TEST(Columns, AreCutFromThePartThatContainsMostOfThem) {
  Street s = post_in_a_hedge();
  s.add_box({5, 10, 16, 14}, 0, 2);  // the hedge is two parts, the first column of the post lies in the other
  PixelLabels parts = s.parts;
  const std::vector<ColumnCut> cuts = cut_columns(s.columns(), 10, parts);
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_EQ(cuts[0].rest, 1u);
  EXPECT_EQ(cuts[0].column, 3u);
  EXPECT_EQ(parts.count, 3u);
  EXPECT_EQ(s.pixels_of(parts, 3), 9u);
  EXPECT_EQ(s.pixels_of(parts, 1) + 6, s.pixels_of(s.parts, 1));
}

// What is little more than a column is no other part.
TEST(Columns, NothingIsCutOfWhichTooLittleIsLeft) {
  Street s;
  s.add_box({20, 15, 4, 4}, kLowBins | kHighBins, 1);
  s.add_box({24, 15, 20, 1}, kLowBins, 1);
  ASSERT_EQ(s.pixels_of(s.columns(), 1), 16u);
  PixelLabels parts = s.parts;
  EXPECT_TRUE(cut_columns(s.columns(), 21, parts).empty());
  EXPECT_EQ(parts.of, s.parts.of);
  EXPECT_EQ(cut_columns(s.columns(), 20, parts).size(), 1u);
}

// The tree holds a part as it was before its columns were cut, and all above.
TEST(Columns, AreJoinedFirstWithWhatTheyWereCutFrom) {
  Street s = post_in_a_hedge();
  s.add_box({40, 15, 3, 3}, kLowBins | kHighBins, 1);
  s.add_box({45, 10, 10, 14}, kLowBins, 2);
  Image heights = filled_image(kWidth, kHeight, kNoHeight);
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (s.parts.of[i] != 0) heights.values[i] = 600;
  PixelLabels parts = s.parts;
  const std::vector<ColumnCut> cuts = cut_columns(s.columns(), 10, parts);
  ASSERT_EQ(cuts.size(), 2u);
  const Joins joins = joins_of(parts, heights, 4, 1e9, cuts);
  ASSERT_EQ(joins.list.size(), 3u);
  EXPECT_EQ(joins.list[0].a, 1u);
  EXPECT_EQ(joins.list[0].b, 3u);
  EXPECT_EQ(joins.list[1].a, 5u);  // the first join
  EXPECT_EQ(joins.list[1].b, 4u);
  EXPECT_EQ(joins.list[2].a, 2u);  // then that with the other part
  EXPECT_EQ(joins.list[2].b, 6u);
}

// The heights at which a post and a hedge touch, and at which it is free.
TEST(PartContacts, GiveTheHeightsAtWhichCandidatesTouch) {
  const Street s = post_in_a_hedge();
  PixelLabels parts = s.parts;
  const std::vector<ColumnCut> cuts = cut_columns(s.columns(), 10, parts);
  ASSERT_EQ(cuts.size(), 1u);
  std::vector<ObjectCandidate> candidates(3);
  set_contacts(parts, s.occupancy, std::vector<Join>{{1, 2, 1}}, {}, candidates);
  const auto of = [&](std::size_t candidate, CandidateFeature f) {
    return candidates[candidate].features[static_cast<std::size_t>(f)];
  };
  EXPECT_DOUBLE_EQ(of(0, CandidateFeature::touch_share), 1);  // the hedge, 5 bins
  EXPECT_DOUBLE_EQ(of(1, CandidateFeature::touch_share), 5.0 / 17);
  EXPECT_DOUBLE_EQ(of(1, CandidateFeature::free_run), 1.2);
  EXPECT_DOUBLE_EQ(of(1, CandidateFeature::upright_share), 17.0 / 18);
  EXPECT_DOUBLE_EQ(of(1, CandidateFeature::evenness), 17.0 / 18);  // as many pixels in all of its bins
  EXPECT_DOUBLE_EQ(of(2, CandidateFeature::evenness), (5 * 560 + 12 * 9) / (18.0 * 560));
  EXPECT_DOUBLE_EQ(of(2, CandidateFeature::touch_share), 0);
  EXPECT_DOUBLE_EQ(of(2, CandidateFeature::free_run), 1.7);
  EXPECT_DOUBLE_EQ(of(2, CandidateFeature::joint_share), 1);  // of the hedge's bins all
  EXPECT_DOUBLE_EQ(of(0, CandidateFeature::joint_share), 1);
}

// Bodies that touch at their middles alone; and from the air, where nothing is known of heights.
TEST(PartContacts, ApartAboveAndBelow) {
  Street s;
  s.add_box({10, 10, 6, 6}, 0b1111'1110, 1);
  s.add_box({16, 10, 1, 6}, 0b0001'1000, 1);
  s.add_box({17, 10, 2, 6}, 0b0001'1000, 2);
  s.add_box({19, 10, 6, 6}, 0b1111'1110, 2);
  std::vector<ObjectCandidate> candidates(3);
  const auto joint = static_cast<std::size_t>(CandidateFeature::joint_share);
  set_contacts(s.parts, s.occupancy, std::vector<Join>{{1, 2, 1}}, {}, candidates);
  EXPECT_DOUBLE_EQ(candidates[2].features[joint], 2.0 / 7);
  std::fill(s.occupancy.begin(), s.occupancy.end(), 0);
  set_contacts(s.parts, s.occupancy, std::vector<Join>{{1, 2, 1}}, {}, candidates);
  for (const ObjectCandidate& t : candidates) {
    EXPECT_DOUBLE_EQ(t.features[joint], 1);
    for (const auto f : {CandidateFeature::upright_share, CandidateFeature::evenness, CandidateFeature::free_run,
                         CandidateFeature::touch_share})
      EXPECT_DOUBLE_EQ(t.features[static_cast<std::size_t>(f)], 0);
  }
}

}  // namespace
}  // namespace ilot
