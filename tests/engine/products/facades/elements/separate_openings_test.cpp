// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/separate_openings.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

ElementCandidate window(const Box2& box, double error) {
  ElementCandidate t;
  const double at[4] = {box.v0, box.u1, box.v1, box.u0};
  for (const Side side : kSides) {
    LocatedEdge& edge = t.shape.side(side);
    edge.at = edge.inner = at[static_cast<std::size_t>(side)], edge.error = error;
  }
  return t;
}

TEST(SeparateOpenings, TheSideThatIsKnownWorseIsOpened) {
  std::vector<ElementCandidate> both{window({1, 3.2, 1, 2}, 0.02), window({2.9, 4.4, 1, 2}, 0.02)};
  both[0].shape.side(Side::right).form = 1.2;
  open_overlapping_sides(both);
  const LocatedEdge& opened = both[0].shape.side(Side::right);
  EXPECT_EQ(opened.status, DrawnStatus::occluded);
  EXPECT_DOUBLE_EQ(opened.inner, 2);                  // its error allows no less
  EXPECT_NEAR(opened.at + opened.error, 2.9, 1e-12);  // and the other opening no more
  EXPECT_DOUBLE_EQ(both[1].shape.at(Side::left), 2.9);
  EXPECT_EQ(both[1].shape.side(Side::left).status, DrawnStatus::seen);
}

TEST(SeparateOpenings, AnOpenedSideIsCompletedFromOthersOfItsSize) {
  std::vector<ElementCandidate> row{window({1, 3.2, 1, 2}, 0.02), window({2.9, 4.4, 1, 2}, 0.02),
                                    window({5, 6.5, 1, 2}, 0.02), window({7, 8.5, 1, 2}, 0.02)};
  row[0].shape.side(Side::right).form = 1.2;
  group_elements(row);
  open_overlapping_sides(row);
  complete_elements(row);
  EXPECT_EQ(row[0].shape.side(Side::right).status, DrawnStatus::completed);
  EXPECT_NEAR(row[0].shape.at(Side::right), 2.5, 1e-9);
}

TEST(SeparateOpenings, NoSideIsCompletedIntoAnotherOpening) {
  std::vector<ElementCandidate> row{window({1, 1.8, 1, 2}, 0.02), window({2.2, 2.9, 1, 2}, 0.02),
                                    window({5, 6.5, 1, 2}, 0.02), window({7, 8.5, 1, 2}, 0.02)};
  LocatedEdge& hidden = row[0].shape.side(Side::right);
  hidden.status = DrawnStatus::occluded, hidden.inner = 1.7, hidden.at = 2.2, hidden.error = 0.5;
  group_elements(row);
  EXPECT_TRUE(reaches_into_other(row, 0, Side::right, 2.5));
  EXPECT_FALSE(reaches_into_other(row, 0, Side::right, 2.1));
  complete_elements(row);
  EXPECT_NE(row[0].shape.side(Side::right).status, DrawnStatus::completed);
}

TEST(SeparateOpenings, WhatOverlapsStillEndsBeforeTheOther) {
  std::vector<ElementCandidate> both{window({1, 3.2, 1, 2}, 0.4), window({2.9, 4.4, 1, 2}, 0.02)};
  both[0].shape.arc = TopArc{{2.1, 0.9}, 1.1};
  end_before_others(both);
  EXPECT_DOUBLE_EQ(both[0].shape.at(Side::right), 2.9);
  EXPECT_GE(both[0].shape.error(Side::right), 0.3);
  EXPECT_FALSE(both[0].shape.arc);  // it was found between other jambs
  // Nobody saw either side: both end in the middle.
  both = {window({1, 3.2, 1, 2}, 0.4), window({2.9, 4.4, 1, 2}, 0.4)};
  both[0].shape.side(Side::right).status = both[1].shape.side(Side::left).status = DrawnStatus::completed;
  end_before_others(both);
  EXPECT_DOUBLE_EQ(both[0].shape.at(Side::right), 3.05);
  EXPECT_DOUBLE_EQ(both[1].shape.at(Side::left), 3.05);
}

TEST(SeparateOpenings, ASideThatLeansIntoAnotherOpeningStandsUpright) {
  std::vector<ElementCandidate> both{window({1, 2.6, 1, 2}, 0.5), window({2.9, 4.4, 1, 2}, 0.02)};
  both[0].shape.lean[static_cast<std::size_t>(Side::right)] = 0.8;  // its corner is at 3
  open_overlapping_sides(both);
  EXPECT_FALSE(both[0].shape.leans());
  EXPECT_LE(both[0].shape.at(Side::right), 2.9);
  EXPECT_EQ(both[0].shape.side(Side::right).status, DrawnStatus::occluded);
}

TEST(SeparateOpenings, WhatDoesNotOverlapStays) {
  const std::vector<ElementCandidate> apart{window({1, 2, 1, 2}, 0.4), window({2.2, 3.2, 1, 2}, 0.4),
                                            window({1, 2, 2.3, 3.3}, 0.4)};
  std::vector<ElementCandidate> now = apart;
  open_overlapping_sides(now);
  end_before_others(now);
  for (std::size_t i = 0; i < now.size(); ++i)
    for (const Side side : kSides) {
      EXPECT_EQ(now[i].shape.at(side), apart[i].shape.at(side));
      EXPECT_EQ(now[i].shape.side(side).status, DrawnStatus::seen);
    }
}

}  // namespace
}  // namespace ilot
