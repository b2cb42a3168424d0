// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/planes/plane_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Appends `count` points that carry both labels.
void put(std::vector<std::uint32_t>& truth, std::vector<std::uint32_t>& found, std::uint32_t t, std::uint32_t f,
         int count) {
  truth.insert(truth.end(), static_cast<std::size_t>(count), t);
  found.insert(found.end(), static_cast<std::size_t>(count), f);
}

TEST(PlaneMatching, CountsAHandMadeCase) {
  std::vector<std::uint32_t> truth, found;
  put(truth, found, 1, 7, 90);  // plane 1 is found as 7, with a hole
  put(truth, found, 1, 0, 10);
  put(truth, found, 2, 8, 40);  // plane 2 falls into 8 and 9
  put(truth, found, 2, 9, 30);
  put(truth, found, 3, 5, 50);  // planes 3 and 4 are one found plane
  put(truth, found, 4, 5, 45);
  put(truth, found, 0, 7, 10);  // clutter on plane 7
  put(truth, found, 0, 6, 12);  // a plane where there is none
  put(truth, found, 5, 0, 20);  // plane 5 is not found
  const PlaneMatching m = match_planes(truth, found);
  EXPECT_EQ(m.true_planes, 5u);
  EXPECT_EQ(m.found_planes, 5u);
  ASSERT_EQ(m.matches.size(), 3u);
  EXPECT_EQ(m.matches[0].found, 7u);
  EXPECT_EQ(m.matches[1].found, 8u);
  EXPECT_EQ(m.matches[2].found, 5u);
  EXPECT_EQ(m.missed, 2u);
  EXPECT_EQ(m.over, 1u);
  EXPECT_EQ(m.under, 1u);
  EXPECT_EQ(m.points, 285u);
  EXPECT_EQ(m.carrying, 90u + 40u + 50u);
  ASSERT_EQ(m.found.size(), 5u);
  EXPECT_EQ(m.found[0].id, 5u);
  EXPECT_DOUBLE_EQ(m.found[0].foreign_share(), 45.0 / 95);
  EXPECT_EQ(m.found[2].points, 100u);
  EXPECT_EQ(m.found[2].foreign, 0u);
}

TEST(PlaneMatching, JudgesOnlyThePlanesAskedForButWithAllTheirPoints) {
  std::vector<std::uint32_t> truth, found;
  put(truth, found, 1, 1, 80);  // a roof
  put(truth, found, 2, 1, 20);  // a wall that the found roof took points from
  put(truth, found, 2, 2, 30);
  LabelPairs pairs;
  for (std::size_t i = 0; i < truth.size(); ++i) pairs.add(truth[i], found[i]);
  const PlaneMatching m = match_planes(pairs.sorted(), [](std::uint32_t id) { return id == 1; });
  EXPECT_EQ(m.true_planes, 1u);
  ASSERT_EQ(m.found.size(), 1u);
  EXPECT_DOUBLE_EQ(m.found[0].foreign_share(), 0.2);
  EXPECT_DOUBLE_EQ(m.share(), 1.0);
}

TEST(PlaneMatching, APairWithHalfOfTheFoundPlaneOrLessDoesNotQualify) {
  std::vector<std::uint32_t> truth, found;
  put(truth, found, 1, 3, 10);
  put(truth, found, 2, 3, 10);
  const PlaneMatching m = match_planes(truth, found);
  EXPECT_TRUE(m.matches.empty());
  EXPECT_EQ(m.missed, 2u);
  EXPECT_EQ(m.under, 1u);
}

TEST(PlaneMatching, NothingGivesNothing) {
  const PlaneMatching m = match_planes(std::vector<std::uint32_t>{}, std::vector<std::uint32_t>{});
  EXPECT_EQ(m.true_planes + m.found_planes + m.missed + m.points, 0u);
  EXPECT_EQ(m.share(), 0);
}

TEST(PlaneMatching, IsPerfectUnderAnyRenumberingAndOrder) {
  Rng rng(3);
  std::vector<std::uint32_t> truth(5000), found(5000);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    truth[i] = static_cast<std::uint32_t>(rng.below(50));
    found[i] = truth[i] == 0 ? 0 : 1 + (truth[i] * 37) % 1009;
  }
  const PlaneMatching m = match_planes(truth, found);
  EXPECT_EQ(m.matches.size(), 49u);
  EXPECT_EQ(m.carrying, m.points);
  EXPECT_EQ(m.missed + m.over + m.under, 0u);
  std::reverse(truth.begin(), truth.end());
  std::reverse(found.begin(), found.end());
  EXPECT_EQ(match_planes(truth, found).carrying, m.carrying);
}

TEST(PlaneMatching, ByOverlapAsksHalfOfBothTogether) {
  std::vector<std::uint32_t> truth, found;
  put(truth, found, 1, 1, 50);  // half of 1 and 1 together
  put(truth, found, 1, 0, 30);
  put(truth, found, 0, 1, 20);
  put(truth, found, 2, 2, 40);  // all of what was found, but 40 of 81
  put(truth, found, 2, 0, 41);
  LabelPairs pairs;
  for (std::size_t i = 0; i < truth.size(); ++i) pairs.add(truth[i], found[i]);
  EXPECT_EQ(match_planes(pairs.sorted(), {}, MatchRule::main).matches.size(), 2u);
  const PlaneMatching m = match_planes(pairs.sorted(), {}, MatchRule::overlap);
  ASSERT_EQ(m.matches.size(), 1u);
  EXPECT_EQ(m.matches[0].truth, 1u);
  EXPECT_EQ(m.missed, 1u);
}

// Identities that hold for any labels at all.
TEST(PlaneMatching, CountsAddUpOnRandomLabels) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    std::vector<std::uint32_t> truth(400), found(400);
    for (auto& label : truth) label = static_cast<std::uint32_t>(rng.below(6));
    for (auto& label : found) label = static_cast<std::uint32_t>(rng.below(9));
    const PlaneMatching m = match_planes(truth, found);
    EXPECT_EQ(m.matches.size() + m.missed, m.true_planes);
    const auto owned = truth.size() - static_cast<std::size_t>(std::count(truth.begin(), truth.end(), 0u));
    EXPECT_EQ(m.points, owned);
    std::uint64_t brute = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
      for (const PlaneMatch& match : m.matches) brute += truth[i] == match.truth && found[i] == match.found;
    EXPECT_EQ(m.carrying, brute);
    for (std::size_t i = 1; i < m.matches.size(); ++i) EXPECT_LT(m.matches[i - 1].truth, m.matches[i].truth);
  }
}

}  // namespace
}  // namespace ilot
