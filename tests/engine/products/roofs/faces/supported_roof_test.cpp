// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/supported_roof.h"

#include <gtest/gtest.h>

#include "tests/support/roof_sites.h"

namespace ilot {
namespace {

// Points up to half a metre beyond x = 12, the end of a house.
std::vector<Vec3> beyond_the_end(const std::function<double(double, double)>& height) {
  std::vector<Vec3> points;
  Rng rng(5);
  for (int i = 0; i < 200; ++i) {
    const double x = 12.01 + 0.48 * rng.uniform(), y = 6 * rng.uniform();
    points.push_back({x, y, height(x, y) + 0.03 * (rng.uniform() - 0.5)});
  }
  return points;
}

double gable_roof(double, double y) {
  return 4 + std::min(y, 6 - y);
}

TEST(SupportedRoof, PointsBesideTheOutlineOnItsPlanesAreTaken) {
  RoofSite site = test::roof_site(12, 6, gable_roof);
  site.beside = beyond_the_end(gable_roof);
  const SupportedRoof roof = supported_roof(site, {});
  EXPECT_EQ(roof.planes.planes.size(), 2u);
  EXPECT_GT(roof.beside.size(), 190u);
  EXPECT_EQ(roof.site.points.size(), site.points.size() + roof.beside.size());
  EXPECT_EQ(roof.planes.of_point.size(), roof.site.points.size());
}

TEST(SupportedRoof, TheRoofOfANeighbourIsNot) {
  RoofSite site = test::roof_site(12, 6, gable_roof);
  site.beside = beyond_the_end([](double, double) { return 11.0; });
  const SupportedRoof roof = supported_roof(site, {});
  EXPECT_EQ(roof.planes.planes.size(), 2u);
  EXPECT_TRUE(roof.beside.empty());
  EXPECT_EQ(roof.site.points.size(), site.points.size());
}

TEST(SupportedRoof, ValuesReturnToTheGivenPoints) {
  RoofSite site;
  site.points.resize(2);
  site.beside.resize(3);
  SupportedRoof roof;
  roof.beside = {0, 2};
  EXPECT_EQ(of_given_points(site, roof, std::vector<std::uint32_t>{7, 8, 9, 10}),
            (std::vector<std::uint32_t>{7, 8, 9, 0, 10}));
}

}  // namespace
}  // namespace ilot
