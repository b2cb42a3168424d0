// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/site_points.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

SitePolygon site_square(int x, int y, int side) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}};
}

Surroundings with_role(std::vector<Vec3> points, PointRole role) {
  const std::size_t n = points.size();
  return {std::move(points), std::vector<PointRole>(n, role)};
}

void add(Surroundings& around, Vec3 p, PointRole role) {
  around.points.push_back(p);
  around.roles.push_back(role);
}

TEST(SitePoints, APointIsInTheOutlineOrBesideItOrNeither) {
  const auto around = with_role({{5, 5, 3},        // in it
                                 {9.9, 5, 3},      // near its edge
                                 {10.1, 5, 3},     // outside, within the margin
                                 {-0.4, 5, 3},     // the same
                                 {-0.6, 5, 3},     // beyond it
                                 {10.3, 10.3, 3},  // within the margin of the corner
                                 {10.4, 10.4, 3}},
                                PointRole::building);
  const SitePoints site = choose_points(around, site_square(0, 0, 10000));
  EXPECT_EQ(site.building, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(site.beside, (std::vector<std::uint32_t>{2, 3, 5}));
}

TEST(SitePoints, PointsBesideTheOutlineDoNotDecideTheClass) {
  Surroundings around;
  add(around, {5, 5, 6}, PointRole::unclassified);
  add(around, {10.2, 5, 6}, PointRole::building);  // the neighbour's
  const SitePoints site = choose_points(around, site_square(0, 0, 10000));
  EXPECT_FALSE(site.rule.by_class);
  EXPECT_EQ(site.building, (std::vector<std::uint32_t>{0}));
  EXPECT_TRUE(site.beside.empty());
}

TEST(SitePoints, AwayRisesFromTheEdgesToTheMargin) {
  const SiteFilter filter(site_square(0, 0, 10000));
  EXPECT_EQ(filter.away({5, 5, 3}), 0);
  EXPECT_EQ(filter.away({10.001, 5, 3}), 1);
  EXPECT_LT(filter.away({10.1, 5, 3}), filter.away({10.3, 5, 3}));
  EXPECT_EQ(filter.away({10.6, 5, 3}), 255);
}

TEST(SitePoints, PointsOnCommonEdgesHaveOneOwner) {
  const std::vector<SitePolygon> outlines{site_square(0, 0, 4000), site_square(4000, 0, 4000),
                                          site_square(0, 4000, 4000), site_square(4000, 4000, 4000)};
  std::vector<Vec3> points;
  for (int i = 1; i < 8; ++i) points.push_back({4, i * 1.0, 1}), points.push_back({i * 1.0, 4, 1});
  const auto around = with_role(points, PointRole::building);
  std::vector<int> owners(points.size());
  for (std::size_t own = 0; own < 4; ++own)
    for (const std::uint32_t i : choose_points(around, outlines[own]).building) ++owners[i];
  EXPECT_EQ(owners, std::vector<int>(points.size(), 1));
}

TEST(SitePoints, ACourtyardIsOutside) {
  const SitePolygon outline{site_square(0, 0, 20000)[0], {{5000, 5000}, {5000, 15000}, {15000, 15000}, {15000, 5000}}};
  Surroundings around;
  add(around, {2, 2, 8}, PointRole::building);
  add(around, {10, 10, 8}, PointRole::building);
  add(around, {6, 6, 1}, PointRole::ground);
  add(around, {10, 10, -5}, PointRole::ground);  // farther than the reach
  const SitePoints site = choose_points(around, outline);
  EXPECT_EQ(site.building, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(site.rule.ground_source, GroundSource::measured);
  EXPECT_EQ(site.rule.ground, 1);
}

TEST(SitePoints, GroundIsALowQuantileOfThePointsAroundTheOutline) {
  const SitePolygon outline = site_square(0, 0, 10000);
  Surroundings around;
  add(around, {5, 5, 9}, PointRole::building);
  for (int i = 0; i <= 100; ++i) add(around, {-1.0, 0.1 * i, 2 + 0.01 * i}, PointRole::ground);
  add(around, {15, 5, -50}, PointRole::ground);    // too far
  add(around, {-4.5, 5, -50}, PointRole::ground);  // too far
  add(around, {-1, 5, -50}, PointRole::other);
  const SitePoints site = choose_points(around, outline);
  EXPECT_EQ(site.rule.ground_source, GroundSource::measured);
  EXPECT_NEAR(site.rule.ground, 2.1, 1e-9);
}

TEST(SitePoints, WithoutGroundTheLowestPointNearTheEdgesCounts) {
  const SitePolygon outline = site_square(0, 0, 10000);
  auto around = with_role({{5, 5, -3}, {0.2, 5, 4}, {9.9, 9, 2.5}, {5, 2, 9}}, PointRole::building);
  SitePoints site = choose_points(around, outline);
  EXPECT_EQ(site.rule.ground_source, GroundSource::lowest_point);
  EXPECT_EQ(site.rule.ground, 2.5);
  around = with_role({{5, 5, -3}, {5, 2, 9}}, PointRole::building);
  site = choose_points(around, outline);
  EXPECT_EQ(site.rule.ground, -3) << "none near the edges: the lowest";
  EXPECT_EQ(choose_points({}, outline).rule.ground_source, GroundSource::none);
}

TEST(SitePoints, WithoutTheClassUnclassifiedPointsThatRiseFromTheGroundAreTaken) {
  const SitePolygon outline = site_square(0, 0, 10000);
  Surroundings around;
  add(around, {5, 5, 6}, PointRole::unclassified);
  add(around, {6, 5, 0.5}, PointRole::unclassified);
  add(around, {7, 5, 7}, PointRole::other);
  SitePoints site = choose_points(around, outline);
  EXPECT_FALSE(site.rule.by_class);
  EXPECT_EQ(site.building, (std::vector<std::uint32_t>{0, 1})) << "nobody knows the ground";
  add(around, {-1, 5, 0}, PointRole::ground);
  site = choose_points(around, outline);
  EXPECT_EQ(site.building, (std::vector<std::uint32_t>{0}));
  add(around, {3, 3, 5}, PointRole::building);
  site = choose_points(around, outline);
  EXPECT_TRUE(site.rule.by_class);
  EXPECT_EQ(site.building, (std::vector<std::uint32_t>{4}));
}

TEST(SitePoints, RolesOfCodes) {
  const auto roles = point_roles(std::vector<int>{6, 67}, std::vector<int>{2});
  EXPECT_EQ(roles[6], PointRole::building);
  EXPECT_EQ(roles[67], PointRole::building);
  EXPECT_EQ(roles[2], PointRole::ground);
  EXPECT_EQ(roles[0], PointRole::unclassified);
  EXPECT_EQ(roles[1], PointRole::unclassified);
  EXPECT_EQ(roles[5], PointRole::other);
  EXPECT_EQ(point_roles(std::vector<int>{1}, {})[1], PointRole::building) << "the mapping comes first";
}

}  // namespace
}  // namespace ilot
