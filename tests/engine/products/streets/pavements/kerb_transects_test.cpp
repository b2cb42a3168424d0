// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/pavements/kerb_transects.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ilot {
namespace {

TEST(KerbTransects, PlacesAreAMetreApartFromTheStartOfTheKerb) {
  const std::vector<Vec3> line{{0, 0, 1}, {2.2, 0, 1.22}, {4.7, 0, 1.47}};
  const std::vector<Transect> places = transects_along(line, 1);
  ASSERT_EQ(places.size(), 5u) << "the last is at 4.5 m";
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double s = static_cast<double>(i) + 0.5;
    EXPECT_EQ(places[i].number, i + 1);
    EXPECT_NEAR(places[i].at.x, s, 1e-12);
    EXPECT_NEAR(places[i].at.z, 1 + 0.1 * s, 1e-12);
    EXPECT_NEAR(places[i].across_y, 1, 1e-12) << "the pavement is on the left";
  }
  EXPECT_TRUE(transects_along(std::vector<Vec3>{{0, 0, 0}, {0.4, 0, 0}}, 1).empty());
}

TEST(KerbTransects, DirectionsTurnWithTheKerb) {
  std::vector<Vec3> arc;
  for (int i = 0; i <= 90; ++i) arc.push_back({10 * std::sin(i * M_PI / 180), 10 - 10 * std::cos(i * M_PI / 180), 0});
  for (const Transect& t : transects_along(arc, 1)) {
    const Vec3 to_middle = Vec3{0, 10, 0} - t.at;
    EXPECT_GT((to_middle.x * t.across_x + to_middle.y * t.across_y) / 10, 0.995);
  }
}

TEST(KerbTransects, TheNextKerbAcrossTheRoad) {
  const std::vector<std::vector<Vec3>> lines{{{0, 0, 0}, {30, 0, 0}}, {{30, 7, 0}, {0, 7, 0}}, {{0, 9, 0}, {10, 9, 0}}};
  const KerbLookup kerbs(lines);
  EXPECT_NEAR(kerbs.next(5.5, 7, 0, -1, 0.5, 30).distance, 7, 1e-12);
  EXPECT_NEAR(kerbs.next(5.5, 7, 0, 1, 0.5, 30).distance, 2, 1e-12);
  EXPECT_TRUE(std::isinf(kerbs.next(15, 7, 0, 1, 0.5, 30).distance));
  EXPECT_TRUE(std::isinf(kerbs.next(5.5, 7, 0, -1, 0.5, 6.9).distance));
  EXPECT_NEAR(kerbs.next(2, 0, std::sqrt(0.5), std::sqrt(0.5), 0.5, 30).distance, 7 * std::sqrt(2), 1e-12);
  EXPECT_TRUE(kerbs.next(5.5, 0, 0, 1, 0.5, 30).faces == false) << "its pavement is on this side";
  EXPECT_EQ(kerbs.next(5.5, 0, 0, 1, 0.5, 30).line, 1u);
}

}  // namespace
}  // namespace ilot
