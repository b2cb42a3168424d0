// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/site_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ilot {
namespace {

FootprintPolygon square(double x, double y, double side) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}};
}

std::vector<std::string> ids_of(const std::vector<PlannedSite>& sites) {
  std::vector<std::string> ids;
  for (const PlannedSite& s : sites) ids.push_back(s.id);
  return ids;
}

TEST(SitePlan, EveryFootprintComesBackInTheOrderOfIds) {
  const std::vector<Footprint> footprints{{"10", {square(100, 100, 10)}, ""},
                                          {"b", {}, "it has no geometry"},
                                          {"9", {square(200, 100, 10), square(250, 100, 20)}, ""},
                                          {"a", {{{{0, 0}, {5, 0}, {9, 0}}}}, ""},
                                          {"7", {{{{0, 0}, {2e5, 0}, {0, 2e5}}}}, ""}};
  const auto sites = plan_sites(footprints, 1);
  EXPECT_EQ(ids_of(sites), (std::vector<std::string>{"7", "9", "10", "9-2", "a", "b"}));
  EXPECT_NE(sites[0].reason, "") << "too large";
  EXPECT_EQ(sites[1].outline.box.min_x, 200000);
  EXPECT_EQ(sites[3].outline.box.max_x, 270000);
  EXPECT_NE(sites[4].reason, "") << "no area";
  EXPECT_EQ(sites[5].reason, "it has no geometry");
  for (const PlannedSite& s : sites) EXPECT_EQ(s.reason.empty(), !s.outline.polygon.empty());
}

TEST(SitePlan, DoesNotDependOnTheOrderOfFootprints) {
  std::vector<Footprint> footprints;
  for (int i = 0; i < 20; ++i) footprints.push_back({std::to_string(i), {square(30.0 * i, 0.0005 * i, 10)}, ""});
  const auto sites = plan_sites(footprints, 1);
  std::reverse(footprints.begin(), footprints.end());
  const auto again = plan_sites(footprints, 1);
  ASSERT_EQ(ids_of(sites), ids_of(again));
  for (std::size_t i = 0; i < sites.size(); ++i) EXPECT_EQ(sites[i].outline.polygon, again[i].outline.polygon);
}

TEST(SitePlan, FeetBecomeMillimetres) {
  const auto sites = plan_sites(std::vector<Footprint>{{"1", {square(1000, 2000, 100)}, ""}}, 0.3048);
  EXPECT_EQ(sites[0].outline.box.min_x, 304800);
  EXPECT_EQ(sites[0].outline.box.max_y, 640080);
}

TEST(SitePlan, NeighboursShareTheVerticesOfTheirWall) {
  const auto sites =
      plan_sites(std::vector<Footprint>{{"1", {square(0.1234, 5, 10)}, ""}, {"2", {square(10.1234, 5, 10)}, ""}}, 1);
  const auto second = seen_from(sites[1].outline, sites[0].outline.x, sites[0].outline.y);
  int shared = 0;
  for (const Point2 p : sites[0].outline.polygon[0])
    shared += static_cast<int>(std::count(second[0].begin(), second[0].end(), p));
  EXPECT_EQ(shared, 2);
  EXPECT_DOUBLE_EQ(shared_area(sites[0].outline, sites[1].outline), 0);
}

}  // namespace
}  // namespace ilot
