// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/party_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/products/roofs/sites/outline_repair.h"
#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::roof_site;

constexpr double kStep = 0.316;  // of 10 points a square metre

// Houses 10 m deep in a row, ridges along it; a roof's height tells the house.
double row(double x, double y) {
  const double ridge = std::min(y, 10 - y) / 2;
  return (x < 8 ? 6 : x < 15 ? 7.2 : 5.1) + ridge;
}

std::set<std::int32_t> places_x(const std::vector<SitePolygon>& parts) {
  std::set<std::int32_t> xs;
  for (const SitePolygon& p : parts)
    for (const Point2 v : p[0]) xs.insert(v.x);
  return xs;
}

TEST(PartyWalls, ARowComesApartAtItsWalls) {
  const RoofSite site = roof_site(24, 10, row);
  const auto parts = split_at_party_walls(site.outline, site.points, kStep);
  ASSERT_EQ(parts.size(), 3u);
  double area = 0;
  for (const SitePolygon& p : parts) area += area_of(p);
  EXPECT_NEAR(area, 240, 1e-6);
  EXPECT_GE(area_of(parts[0]), area_of(parts[1]));
  for (const std::int32_t x : places_x(parts)) {
    const double at = x * 0.001;
    EXPECT_LT(std::min({at, std::abs(at - 8), std::abs(at - 15), std::abs(at - 24)}), 0.08) << at;
  }
  EXPECT_LE(places_x(parts).size(), 6u) << "neighbours share the vertices of their wall";
}

TEST(PartyWalls, ACutThatMeetsAWallBesideACornerEndsInTheCorner) {
  RoofSite site = roof_site(24, 10, row);
  std::set<std::int32_t> ends;  // of the cuts, on the side y = 0
  for (const SitePolygon& p : split_at_party_walls(site.outline, site.points, kStep))
    for (const Point2 v : p[0])
      if (v.y == 0 && v.x > 0 && v.x < 24000) ends.insert(v.x);
  ASSERT_EQ(ends.size(), 2u);
  site.outline[0].insert(site.outline[0].begin() + 1, {*ends.begin() + 1, 0});
  const auto parts = split_at_party_walls(site.outline, site.points, kStep);
  EXPECT_EQ(parts.size(), 3u);
  for (const SitePolygon& p : parts)
    for (std::size_t v = 0; v < p[0].size(); ++v) EXPECT_GE(squared_distance(p[0][v], p[0][(v + 1) % p[0].size()]), 4);
}

TEST(PartyWalls, OneRoofStaysOne) {
  const auto gable = [](double, double y) { return 5 + std::min(y, 10 - y); };
  const RoofSite house = roof_site(24, 10, gable);
  EXPECT_EQ(split_at_party_walls(house.outline, house.points, kStep).size(), 1u);
  const auto dormers = [&](double x, double y) {
    return gable(x, y) + (y > 1 && y < 4 && static_cast<int>(x) % 6 < 2 ? 1 : 0);
  };
  const RoofSite with_dormers = roof_site(24, 10, dormers);
  EXPECT_EQ(split_at_party_walls(with_dormers.outline, with_dormers.points, kStep).size(), 1u);
}

TEST(PartyWalls, AnAnnexBelongsToItsHouse) {
  const RoofSite site = roof_site(13, 9, [](double x, double) { return x < 10 ? 7.0 : 3.0; });
  EXPECT_EQ(split_at_party_walls(site.outline, site.points, kStep).size(), 1u) << "27 m2";
}

TEST(PartyWalls, DependOnTheSetOfPoints) {
  RoofSite site = roof_site(24, 10, row);
  const auto parts = split_at_party_walls(site.outline, site.points, kStep);
  std::reverse(site.points.begin(), site.points.end());
  site.points.insert(site.points.end(), site.points.begin(), site.points.begin() + 50);
  EXPECT_EQ(split_at_party_walls(site.outline, site.points, kStep), parts);
}

TEST(PartyWalls, WithoutPointsNothingIsCut) {
  EXPECT_EQ(split_at_party_walls(test::rectangle(30, 10), {}, kStep).size(), 1u);
  EXPECT_EQ(split_at_party_walls(test::rectangle(30, 10), {}, 0).size(), 1u);
}

}  // namespace
}  // namespace ilot
