// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/regular_facade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

ElementCandidate candidate(double u0, double u1, double v0, double v1, double error,
                           ElementKind kind = ElementKind::window) {
  ElementCandidate t;
  t.kind = kind;
  const double at[4] = {v0, u1, v1, u0};
  for (const Side side : kSides) {
    t.shape.side(side).at = t.shape.side(side).inner = at[static_cast<std::size_t>(side)];
    t.shape.side(side).error = error;
  }
  return t;
}

std::vector<ElementCandidate> grid(double noise, double error) {
  Rng rng(4);
  const auto off = [&] { return noise * (2 * rng.uniform() - 1); };
  std::vector<ElementCandidate> candidates;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 5; ++column)
      candidates.push_back(candidate(3.0 * column + off(), 3.0 * column + 1.1 + off(), 3.0 * row + off(),
                                     3.0 * row + 1.7 + off(), error));
  return candidates;
}

TEST(RegularFacade, RowsColumnsAndOneFamily) {
  std::vector<ElementCandidate> candidates = grid(0.01, 0.012);
  group_elements(candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    EXPECT_EQ(candidates[i].row, i / 5 + 1);
    EXPECT_EQ(candidates[i].column, i % 5 + 1);
    EXPECT_EQ(candidates[i].family, 1u);
  }
}

TEST(RegularFacade, EdgesMoveNoFartherThanTheirErrorAndNearerToTheTruth) {
  const std::vector<ElementCandidate> before = grid(0.006, 0.008);
  std::vector<ElementCandidate> candidates = before;
  regularise_elements(candidates);
  double off_before = 0, off_after = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double truth = 3.0 * static_cast<double>(i % 5);
    off_before += std::abs(before[i].shape.at(Side::left) - truth);
    off_after += std::abs(candidates[i].shape.at(Side::left) - truth);
    for (const Side side : kSides) {
      const double moved = std::abs(candidates[i].shape.at(side) - before[i].shape.at(side));
      EXPECT_LE(moved, 0.008 + 1e-12);
      EXPECT_GE(candidates[i].shape.side(side).moved, moved - 1e-12);
      EXPECT_LE(candidates[i].shape.error(side), 0.008);
    }
  }
  EXPECT_LT(off_after, off_before);
}

// Windows that were not built alike are not made alike, although each differs from the next by less than its error.
TEST(RegularFacade, WhatScattersMoreThanItsErrorsStaysAsItWasMeasured) {
  std::vector<ElementCandidate> candidates = grid(0.02, 0.008);
  const auto before = candidates;
  regularise_elements(candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (const Side side : kSides) EXPECT_EQ(candidates[i].shape.at(side), before[i].shape.at(side));
}

TEST(RegularFacade, AgreementDoesNotMakeAnErrorSmaller) {
  std::vector<ElementCandidate> candidates = grid(0.004, 0.008);
  for (const Side side : kSides) candidates[7].shape.side(side).error = 0.002;
  regularise_elements(candidates);
  double moved = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (const Side side : kSides) {
      EXPECT_EQ(candidates[i].shape.error(side), i == 7 ? 0.002 : 0.008);
      EXPECT_LE(candidates[i].shape.side(side).moved, candidates[i].shape.error(side));
      moved += candidates[i].shape.side(side).moved;
    }
  EXPECT_GT(moved, 0);
}

// A side that nobody saw may be anywhere in the gap that hides it, whatever its row says.
TEST(RegularFacade, WhatNobodySawSaysSoInItsError) {
  std::vector<ElementCandidate> candidates{candidate(0, 1.1, 3, 4.7, 0.002), candidate(3, 4.1, 3, 4.7, 0.002),
                                           candidate(6, 7.1, 3, 4.7, 0.002)};
  LocatedEdge& bottom = candidates[2].shape.side(Side::bottom);
  bottom.status = DrawnStatus::occluded;
  bottom.inner = 3.3, bottom.at = 3.1, bottom.error = 0.2;
  group_elements(candidates);
  complete_elements(candidates);
  EXPECT_EQ(bottom.status, DrawnStatus::completed);
  EXPECT_NEAR(bottom.at, 3, 0.003);
  EXPECT_GE(bottom.error, 0.29);
}

TEST(RegularFacade, WhatIsSurelyDifferentStaysSo) {
  std::vector<ElementCandidate> candidates{candidate(0, 1, 0, 1.5, 0.001), candidate(3, 4.02, 0.02, 1.5, 0.001)};
  const auto before = candidates;
  regularise_elements(candidates);
  for (std::size_t i = 0; i < 2; ++i)
    for (const Side side : kSides) EXPECT_NEAR(candidates[i].shape.at(side), before[i].shape.at(side), 1e-12);
}

TEST(RegularFacade, OrderDoesNotMatter) {
  std::vector<ElementCandidate> candidates = grid(0.008, 0.008), turned = candidates;
  std::reverse(turned.begin(), turned.end());
  regularise_elements(candidates);
  regularise_elements(turned);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (const Side side : kSides)
      EXPECT_EQ(candidates[i].shape.at(side), turned[candidates.size() - 1 - i].shape.at(side));
}

TEST(RegularFacade, HiddenSidesComeFromTheSillTheRowOrTheSize) {
  std::vector<ElementCandidate> candidates{candidate(0, 1.1, 3, 4.7, 0.002), candidate(3, 4.1, 3, 4.7, 0.002),
                                           candidate(6, 7.1, 3.05, 4.7, 0.002),
                                           candidate(5.9, 7.2, 2.85, 3, 0.001, ElementKind::sill)};
  LocatedEdge& bottom = candidates[2].shape.side(Side::bottom);
  bottom.status = DrawnStatus::occluded;
  bottom.inner = 3.05, bottom.at = 2.95, bottom.error = 0.1;
  LocatedEdge& right = candidates[1].shape.side(Side::right);
  right.status = DrawnStatus::occluded;
  right.at = right.inner = 3.6, right.error = 3;
  LocatedEdge& low = candidates[0].shape.side(Side::bottom);
  low.status = DrawnStatus::occluded;
  low.at = low.inner = 3.4, low.error = 3;
  group_elements(candidates);
  complete_elements(candidates);
  EXPECT_NEAR(candidates[2].shape.at(Side::bottom), 3, 1e-12);
  EXPECT_NEAR(candidates[1].shape.at(Side::right), 4.1, 0.003);
  EXPECT_NEAR(candidates[0].shape.at(Side::bottom), 3, 0.003);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(candidates[i].reason.empty());
  EXPECT_EQ(candidates[1].shape.side(Side::right).status, DrawnStatus::completed);
}

// Others of another size are more, but those beside it were built as it was.
TEST(RegularFacade, HiddenSidesTakeTheSizeOfTheirRow) {
  std::vector<ElementCandidate> candidates{candidate(0, 1.3, 6, 8, 0.002), candidate(3, 4.3, 6, 8, 0.002)};
  for (const double u : {0.0, 3.0, 6.0, 9.0}) candidates.push_back(candidate(u, u + 1.2, 2, 4, 0.002));
  LocatedEdge& left = candidates[1].shape.side(Side::left);
  left.status = DrawnStatus::occluded;
  left.at = left.inner = 3.2, left.error = 3;
  group_elements(candidates);
  complete_elements(candidates);
  EXPECT_NEAR(candidates[1].shape.at(Side::left), 3, 0.005);
  EXPECT_EQ(candidates[1].shape.side(Side::left).status, DrawnStatus::completed);
}

TEST(RegularFacade, NoHiddenBottomIsBelowTheFootOfTheWall) {
  // Where the ground rises, the hidden foot of a lower door is not a whole door below its head.
  std::vector<ElementCandidate> doors{candidate(0, 1, 0.1, 2.4, 0.01, ElementKind::door),
                                      candidate(3, 4, 0.9, 1.8, 0.01, ElementKind::door)};
  LocatedEdge& hidden = doors[1].shape.side(Side::bottom);
  hidden.status = DrawnStatus::occluded, hidden.error = 3;
  complete_elements(doors);
  EXPECT_EQ(hidden.status, DrawnStatus::completed);
  EXPECT_DOUBLE_EQ(hidden.at, 0);
  EXPECT_GE(hidden.error, 0.9);
}

TEST(RegularFacade, NothingToCompleteFromStaysOccluded) {
  std::vector<ElementCandidate> candidates{candidate(0, 1.1, 3, 4.7, 0.002)};
  candidates[0].shape.side(Side::bottom).status = DrawnStatus::occluded;
  candidates[0].shape.side(Side::bottom).inner = 3.3;
  complete_elements(candidates);
  EXPECT_EQ(candidates[0].shape.side(Side::bottom).status, DrawnStatus::occluded);
  EXPECT_EQ(candidates[0].shape.at(Side::bottom), 3.3);
}

// An opening of 1 m by 1 m that was seen, whose bottom may be up to `gap` metres lower.
ElementCandidate hidden_below(double gap) {
  ElementCandidate t = candidate(2, 3, 4, 5, 0.01);
  LocatedEdge& bottom = t.shape.side(Side::bottom);
  bottom.status = DrawnStatus::occluded;
  bottom.error = 3;
  bottom.beyond = gap;
  return t;
}

TEST(RegularFacade, AHiddenSideIsWhereItWasLastSeenToBeOpenIfHalfIsSure) {
  std::vector<ElementCandidate> one{hidden_below(0.9)};
  complete_elements(one);
  EXPECT_FALSE(one[0].possible);
  EXPECT_DOUBLE_EQ(one[0].shape.at(Side::bottom), 4);
  EXPECT_DOUBLE_EQ(one[0].shape.error(Side::bottom), 0.9);
}

TEST(RegularFacade, AHiddenSideIsInTheMiddleOfItsGapIfLessWasSeen) {
  std::vector<ElementCandidate> one{hidden_below(2)};
  complete_elements(one);
  EXPECT_FALSE(one[0].possible);
  EXPECT_DOUBLE_EQ(one[0].shape.at(Side::bottom), 3);
  EXPECT_DOUBLE_EQ(one[0].shape.error(Side::bottom), 1);
  EXPECT_EQ(one[0].shape.side(Side::bottom).status, DrawnStatus::occluded);
}

// Drawn in the middle of a gap of 2.5 m, it would be 2.25 m high: less than half in common with the 1 m that was seen.
TEST(RegularFacade, AnOpeningOfWhichLessThanAThirdWasSeenIsAPossibleOne) {
  std::vector<ElementCandidate> one{hidden_below(2.5), hidden_below(0), hidden_below(1.99)};
  complete_elements(one);
  EXPECT_TRUE(one[0].possible);
  EXPECT_FALSE(one[1].possible);  // nothing is known of the end of its gap
  EXPECT_FALSE(one[2].possible);
}

// 1 m by 1 m was seen of at most 1.7 m by 1.7 m (0.35): the middle has 0.55 in common with the least and 0.63 with the
// most. Of at most 2 m by 2 m (0.25) the middle has 0.44 in common with the least.
TEST(RegularFacade, GapsAcrossAndUpCountTogether) {
  std::vector<ElementCandidate> one{hidden_below(0.7), hidden_below(1)};
  for (ElementCandidate& t : one) {
    LocatedEdge& right = t.shape.side(Side::right);
    right = t.shape.side(Side::bottom);
    right.at = right.inner = 3;
  }
  complete_elements(one);
  EXPECT_FALSE(one[0].possible);
  EXPECT_DOUBLE_EQ(one[0].shape.at(Side::bottom), 3.65);
  EXPECT_DOUBLE_EQ(one[0].shape.at(Side::right), 3.35);
  EXPECT_TRUE(one[1].possible);
}

TEST(RegularFacade, AnOpeningWithoutAreaStaysWhereItWasSeen) {
  std::vector<ElementCandidate> one{hidden_below(2)};
  one[0].shape.side(Side::right).at = one[0].shape.side(Side::right).inner = 2;
  complete_elements(one);
  EXPECT_FALSE(one[0].possible);
  EXPECT_DOUBLE_EQ(one[0].shape.at(Side::bottom), 4);
}

}  // namespace
}  // namespace ilot
