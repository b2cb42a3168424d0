// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/pavements/carriageways.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ilot {
namespace {

StreetKerb kerb_along(std::uint32_t id, std::vector<Vec3> line) {
  StreetKerb kerb;
  kerb.id = id, kerb.line = std::move(line);
  return kerb;
}

// Kerbs have their pavement on the left: that of the southern side runs to the west.
std::vector<StreetKerb> straight_road(double length, double width) {
  return {kerb_along(1, {{0, width, 1}, {length, width, 2}}), kerb_along(2, {{length, 0, 2}, {0, 0, 1}})};
}

TEST(Carriageways, LieBetweenKerbsThatFaceEachOther) {
  const std::vector<Carriageway> roads = find_carriageways(straight_road(20, 7), 1);
  ASSERT_EQ(roads.size(), 1u);
  EXPECT_EQ(roads[0].id, 1u);
  EXPECT_EQ(roads[0].ring.size(), 4u);
  EXPECT_NEAR(roads[0].area_m2, 140, 0.01);
  EXPECT_NEAR(roads[0].width_m, 7, 1e-9);
  EXPECT_NEAR(roads[0].narrowest_m, 7, 1e-9);
  EXPECT_EQ(roads[0].seen_share, 1);
}

TEST(Carriageways, NeedAKerbOnTheOtherSide) {
  std::vector<StreetKerb> kerbs = straight_road(20, 7);
  std::reverse(kerbs[1].line.begin(), kerbs[1].line.end());  // the far side of a pavement, and no road
  EXPECT_TRUE(find_carriageways(kerbs, 1).empty());
  EXPECT_TRUE(find_carriageways(std::vector<StreetKerb>{kerbs[0]}, 1).empty());
  EXPECT_TRUE(find_carriageways(straight_road(20, 31), 1).empty());
  EXPECT_TRUE(find_carriageways(straight_road(2, 7), 1).empty());
}

TEST(Carriageways, IslandsAreHoles) {
  std::vector<StreetKerb> kerbs = straight_road(20, 9);
  kerbs.push_back(kerb_along(3, {{6, 4, 1}, {12, 4, 1}, {12, 5, 1}, {6, 5, 1}, {6, 4, 1}}));
  const std::vector<Carriageway> roads = find_carriageways(kerbs, 1);
  ASSERT_EQ(roads.size(), 1u);
  ASSERT_EQ(roads[0].holes.size(), 1u);
  EXPECT_NEAR(roads[0].area_m2, 180 - 7, 1.01) << "the island, and up to a metre before each of its ends";
}

TEST(Carriageways, GoOnWhereOneKerbIsMissingForAWhile) {
  std::vector<StreetKerb> kerbs{kerb_along(1, {{0, 7, 1}, {40, 7, 1}}), kerb_along(2, {{40, 0, 1}, {25, 0, 1}}),
                                kerb_along(3, {{15, 0, 1}, {0, 0, 1}})};
  const std::vector<Carriageway> roads = find_carriageways(kerbs, 1);
  ASSERT_EQ(roads.size(), 1u);
  EXPECT_NEAR(roads[0].area_m2, 280, 0.01);
  EXPECT_NEAR(roads[0].seen_share, 64.0 / 73, 1e-9)
      << "41 places on one side, 9 of them without a kerb; 32 on the other";
  kerbs[2].line[0].x = 12;  // a gap of 13 m
  EXPECT_EQ(find_carriageways(kerbs, 1).size(), 2u);
  kerbs[2].line[0].x = 15, kerbs[2].line[0].y = kerbs[2].line[1].y = 0.5;  // the road has another width there
  EXPECT_EQ(find_carriageways(kerbs, 1).size(), 2u);
}

TEST(Carriageways, HaveNoSeamWhereAKerbGoesOnUnseen) {
  std::vector<StreetKerb> kerbs{kerb_along(1, {{0, 7, 1}, {10, 7, 1}}), kerb_along(2, {{10, 7, 1}, {16, 7.1, 1}}),
                                kerb_along(3, {{16, 7.1, 1}, {30, 7, 1}}), kerb_along(4, {{30, 0, 1}, {0, 0, 1}})};
  kerbs[1].seen = false;
  const std::vector<Carriageway> roads = find_carriageways(kerbs, 1);
  ASSERT_EQ(roads.size(), 1u);
  EXPECT_TRUE(roads[0].holes.empty());
  EXPECT_NEAR(roads[0].area_m2, 210 + 0.3 + 0.7, 0.3);
  EXPECT_LT(roads[0].seen_share, 0.85);
  EXPECT_GT(roads[0].seen_share, 0.75);
}

TEST(Carriageways, AreInTheUnitsOfTheCrs) {
  std::vector<StreetKerb> kerbs = straight_road(20 / 0.3048, 7 / 0.3048);
  kerbs[1].seen = false;
  const std::vector<Carriageway> roads = find_carriageways(kerbs, 0.3048);
  ASSERT_EQ(roads.size(), 1u);
  EXPECT_NEAR(roads[0].area_m2, 140, 0.01);
  EXPECT_NEAR(roads[0].width_m, 7, 1e-9);
  EXPECT_EQ(roads[0].seen_share, 0);
  const auto right = std::max_element(roads[0].ring.begin(), roads[0].ring.end(),
                                      [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
  EXPECT_NEAR(right->x, 20 / 0.3048, 0.01);
}

TEST(Carriageways, DoNotDependOnTheOrderOfKerbs) {
  std::vector<StreetKerb> kerbs = straight_road(20, 9);
  for (StreetKerb kerb : straight_road(30, 6)) {
    for (Vec3& p : kerb.line) p.y += 40;
    kerbs.push_back(kerb);
  }
  const std::vector<Carriageway> a = find_carriageways(kerbs, 1);
  std::reverse(kerbs.begin(), kerbs.end());
  const std::vector<Carriageway> b = find_carriageways(kerbs, 1);
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(a[i].area_m2, b[i].area_m2);
    ASSERT_EQ(a[i].ring.size(), b[i].ring.size());
    for (std::size_t k = 0; k < a[i].ring.size(); ++k) EXPECT_EQ(norm(a[i].ring[k] - b[i].ring[k]), 0);
  }
}

}  // namespace
}  // namespace ilot
