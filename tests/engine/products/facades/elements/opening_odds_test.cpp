// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/opening_odds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ilot {
namespace {

// An opening on a facade whose axes are x and z, in units of half a metre.
FacadeElement opening(double u, double v, double width, double height, double error, double depth = -0.15) {
  FacadeElement e;
  e.kind = "window";
  e.opening = true;
  e.family = 1;
  e.depth_m = depth;
  e.width_m = width, e.height_m = height;
  for (const auto& [x, z] : {std::pair{u, v}, {u + width, v}, {u + width, v + height}, {u, v + height}})
    e.ring.push_back({2 * x, 0, 2 * z}), e.edges.push_back({DrawnStatus::seen, 50, 0.002, error});
  e.edges[1].error_m *= 2;
  return e;
}

FacadeElement unseen(double u, double v, double width, double height) {
  FacadeElement e = opening(u, v, width, height, 0.5);
  e.opening = false;
  e.region = FacadeRegion::facade;
  e.kind = "not seen";
  e.status = DrawnStatus::occluded;
  return e;
}

constexpr double kMetres = 0.5;  // per unit

// Three windows of a row; below the last one a small hole of which little is known, beside what nobody saw.
Facade row_with_a_hole() {
  Facade f;
  f.right = {1, 0, 0}, f.up = {0, 0, 1}, f.out = {0, -1, 0};
  for (int i = 0; i < 3; ++i) f.elements.push_back(opening(1 + 2.5 * i, 3, 1.1, 1.6, 0.01));
  f.elements.push_back(opening(6.3, 2.3, 0.5, 0.6, 0.2, 0));
  f.elements.push_back(unseen(6.85, 2.2, 1, 0.5));
  for (std::uint32_t i = 0; i < f.elements.size(); ++i) f.elements[i].id = i + 1;
  return f;
}

TEST(OpeningOdds, WhatIsKnownOfAnOpening) {
  const std::vector<OpeningEvidence> all = opening_evidence(row_with_a_hole(), kMetres);
  ASSERT_EQ(all.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(all[i].in_row, 2u);
    EXPECT_EQ(all[i].alike, 2u);
    EXPECT_NEAR(all[i].gap, i == 2 ? 0.1 : 1.4, 1e-9);
    EXPECT_FALSE(all[i].beside_unseen);
    EXPECT_DOUBLE_EQ(all[i].least_error, 0.01);
    EXPECT_DOUBLE_EQ(all[i].greatest_error, 0.02);
  }
  EXPECT_EQ(all[3].element, 3u);
  EXPECT_EQ(all[3].in_row + all[3].alike, 0u);
  EXPECT_NEAR(all[3].gap, 0.1, 1e-9);
  EXPECT_NEAR(all[3].off_column, 0, 1e-9);
  EXPECT_TRUE(all[3].beside_unseen);
}

TEST(OpeningOdds, EvidenceSpeaksForOrAgainst) {
  OpeningEvidence known;
  known.width = 1.1, known.height = 1.6, known.depth = -0.15, known.least_error = 0.01, known.greatest_error = 0.02;
  const auto odds_with = [&](auto change) {
    OpeningEvidence e = known;
    change(e);
    return opening_log_odds(e);
  };
  const double odds = opening_log_odds(known);
  EXPECT_GT(odds, 0);  // a single window that is well known
  EXPECT_GT(odds_with([](OpeningEvidence& e) { e.width = 1, e.height = 0.9; }), 0);
  EXPECT_GT(odds_with([](OpeningEvidence& e) { e.in_row = 3; }), odds);
  EXPECT_GT(odds_with([](OpeningEvidence& e) { e.alike = 3; }), odds);
  EXPECT_GT(odds_with([](OpeningEvidence& e) { e.off_column = 0; }), odds);
  EXPECT_LT(odds_with([](OpeningEvidence& e) { e.least_error = 0.1, e.greatest_error = 0.3; }), odds);
  EXPECT_LT(odds_with([](OpeningEvidence& e) { e.gap = 0.1; }), odds);
  EXPECT_LT(odds_with([](OpeningEvidence& e) { e.height = 0.9; }), odds);
  EXPECT_LT(odds_with([](OpeningEvidence& e) { e.depth = 0; }), odds);
  EXPECT_LT(odds_with([](OpeningEvidence& e) { e.beside_unseen = true; }), odds);
}

TEST(OpeningOdds, SizesBeyondThoseLearntFromCountAsTheNearest) {
  OpeningEvidence small, smaller, large, larger;
  small.width = smaller.width = 0.9, small.height = 0.9, smaller.height = 0.89;
  large.width = larger.width = 3, large.height = 2, larger.height = 4;
  for (OpeningEvidence* e : {&small, &smaller, &large, &larger}) e->least_error = e->greatest_error = 0.02;
  EXPECT_NEAR(opening_log_odds(small), opening_log_odds(smaller), 0.05);
  EXPECT_NEAR(opening_log_odds(large), opening_log_odds(larger), 0.5);
}

TEST(OpeningOdds, WhatIsMoreLikelyNoneIsAPossibleOpening) {
  Facade f = row_with_a_hole();
  const std::vector<FacadeElement> before = f.elements;
  f.elements[3].edges[0].status = DrawnStatus::occluded;
  EXPECT_EQ(keep_likely_openings(f, kMetres), 1u);
  ASSERT_EQ(f.elements.size(), 5u);
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(f.elements[i].id, i + 1);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(f.elements[i].opening);
    EXPECT_EQ(f.elements[i].family, 1u);
    EXPECT_EQ(f.elements[i].width_m, before[i].width_m);
  }
  EXPECT_EQ(f.elements[3].kind, "not seen");
  const FacadeElement& possible = f.elements[4];
  EXPECT_EQ(possible.kind, "possible opening");
  EXPECT_EQ(possible.status, DrawnStatus::occluded);
  EXPECT_FALSE(possible.opening);
  EXPECT_NEAR(possible.width_m, 0.5, 1e-9);
  EXPECT_NEAR(possible.height_m, 0.6, 1e-9);
  EXPECT_NEAR(possible.ring[0].x, 12.6, 1e-9);
  EXPECT_NEAR(possible.ring[2].z, 5.8, 1e-9);
  EXPECT_DOUBLE_EQ(possible.edges[0].error_m, 0.4);
  EXPECT_EQ(keep_likely_openings(f, kMetres), 0u);
}

// The order of the elements does not matter.
TEST(OpeningOdds, AnyOrderOfElements) {
  Facade f = row_with_a_hole(), turned = row_with_a_hole();
  std::reverse(turned.elements.begin(), turned.elements.end());
  keep_likely_openings(f, kMetres);
  keep_likely_openings(turned, kMetres);
  const auto openings = [](const Facade& g) {
    return std::count_if(g.elements.begin(), g.elements.end(), [](const FacadeElement& e) { return e.opening; });
  };
  EXPECT_EQ(openings(f), 3);
  EXPECT_EQ(openings(turned), 3);
  Facade empty;
  EXPECT_EQ(keep_likely_openings(empty, kMetres), 0u);
}

}  // namespace
}  // namespace ilot
