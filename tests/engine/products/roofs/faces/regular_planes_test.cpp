// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/regular_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

using test::roof_site;

struct RegularRoof {
  RoofSite site;
  RoofPlanes found, regular;
};

RegularRoof regular_roof(const std::function<double(double, double)>& height, double noise = 0.02) {
  RegularRoof roof{roof_site(16, 10, height, 10, noise), {}, {}};
  roof.found = find_roof_planes(roof.site, {});
  roof.regular = roof.found;
  make_regular(roof.site.outline, roof.site.points, roof.regular);
  return roof;
}

double steepness(const RoofPlane& p) {
  return std::hypot(p.gx, p.gy);
}

double rms_of_plane(const RegularRoof& roof, const RoofPlanes& planes, std::uint32_t plane) {
  double sum = 0, points = 0;
  for (std::size_t i = 0; i < roof.site.points.size(); ++i) {
    if (planes.of_point[i] != plane + 1) continue;
    const Vec3 p = roof.site.points[i];
    const double off = p.z - planes.planes[plane].at(p.x, p.y);
    sum += off * off, points += 1;
  }
  return std::sqrt(sum / points);
}

double hipped_roof(double x, double y) {
  return 5 + 0.6 * std::min({x, 16 - x, y, 10 - y});
}

TEST(RegularPlanes, AHippedRoofHasOneSteepnessAlongItsSides) {
  const RegularRoof roof = regular_roof(hipped_roof);
  ASSERT_EQ(roof.regular.planes.size(), 4u);
  for (const RoofPlane& p : roof.regular.planes) {
    EXPECT_NEAR(steepness(p), steepness(roof.regular.planes[0]), 1e-12);
    EXPECT_EQ(std::min(std::abs(p.gx), std::abs(p.gy)), 0);
  }
  EXPECT_GT(std::abs(steepness(roof.found.planes[0]) - steepness(roof.found.planes[1])), 1e-6)
      << "nothing to make regular";
}

TEST(RegularPlanes, WhatThePointsShowStays) {
  const RegularRoof roof =
      regular_roof([](double x, double y) { return 5 + std::min(0.6 * y, 0.66 * (10 - y)) + 0.02 * x; });
  ASSERT_EQ(roof.regular.planes.size(), 2u);
  EXPECT_NEAR(std::abs(roof.regular.planes[0].gy) + std::abs(roof.regular.planes[1].gy), 1.26, 0.01);
  EXPECT_GT(std::abs(std::abs(roof.regular.planes[0].gy) - std::abs(roof.regular.planes[1].gy)), 0.05);
  for (const RoofPlane& p : roof.regular.planes) EXPECT_NEAR(p.gx, 0.02, 0.003) << "neither level nor along a side";
}

TEST(RegularPlanes, LevelPartsOfOneHeightAreOnePlane) {
  const RegularRoof roof = regular_roof([](double x, double) { return x < 6 || x > 10 ? 5 : 8; });
  ASSERT_GE(roof.regular.planes.size(), 2u);
  for (const RoofPlane& p : roof.regular.planes) EXPECT_EQ(steepness(p), 0);
  const auto high = [&](const RoofPlane& p) { return p.c > 6; };
  for (const RoofPlane& p : roof.regular.planes)
    for (const RoofPlane& q : roof.regular.planes)
      if (high(p) == high(q)) {
        EXPECT_EQ(p.c, q.c);
      }
}

// Moved by at most half of the residual, a plane in the centre of its points has sqrt(1 + 1/4) of it at most.
TEST(RegularPlanes, ResidualsGrowByAnEighthAtMost) {
  for (const double noise : {0.005, 0.02, 0.05}) {
    const RegularRoof roof = regular_roof(hipped_roof, noise);
    for (std::uint32_t p = 0; p < roof.found.planes.size(); ++p)
      EXPECT_LE(rms_of_plane(roof, roof.regular, p), 1.125 * rms_of_plane(roof, roof.found, p))
          << noise << " m, plane " << p;
  }
}

TEST(RegularPlanes, TheOrderOfPlanesOfDifferentSizesDoesNotMatter) {
  const RegularRoof roof = regular_roof(hipped_roof);
  RoofPlanes turned = roof.found;
  std::reverse(turned.planes.begin(), turned.planes.end());
  const auto last = static_cast<std::uint32_t>(turned.planes.size());
  for (std::uint32_t& label : turned.of_point) label = label == 0 ? 0 : last + 1 - label;
  make_regular(roof.site.outline, roof.site.points, turned);
  std::reverse(turned.planes.begin(), turned.planes.end());
  for (std::size_t p = 0; p < turned.planes.size(); ++p) {
    EXPECT_EQ(turned.planes[p].gx, roof.regular.planes[p].gx);
    EXPECT_EQ(turned.planes[p].gy, roof.regular.planes[p].gy);
    EXPECT_EQ(turned.planes[p].c, roof.regular.planes[p].c);
  }
}

TEST(RegularPlanes, NothingComesOfNothing) {
  RoofPlanes none;
  make_regular({}, {}, none);
  EXPECT_TRUE(none.planes.empty());
  RoofPlanes without_points;
  without_points.planes.resize(1);
  without_points.planes[0].gx = 0.5;
  make_regular(test::rectangle(4, 4), {}, without_points);
  EXPECT_EQ(without_points.planes[0].gx, 0.5);
}

}  // namespace
}  // namespace ilot
