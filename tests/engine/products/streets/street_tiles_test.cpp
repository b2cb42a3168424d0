// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/rng.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

TEST(StreetTiles, ViewsOfDensities) {
  EXPECT_EQ(view_of({30, 0.01, 3.4}), StreetView::air);
  EXPECT_EQ(view_of({11, 0.17, 4.8}), StreetView::air) << "an old town with its walls";
  EXPECT_EQ(view_of({73, 0.22, 120}), StreetView::street) << "a street below crowns from a vehicle";
  EXPECT_EQ(view_of({100, 0.6, 2}), StreetView::street) << "from the ground, thinned to even steps";
  EXPECT_EQ(view_of({340, 0.07, 3}), StreetView::street) << "too dense for a flight";
}

// Points whose density falls with the square of the distance from one side, as on the ground around a scanner.
TEST(StreetTiles, EvenPointsAreFromTheAirAndFallingOnesAreNot) {
  Rng rng(7);
  std::vector<Index3> even, falling;
  for (int i = 0; i < 20 * 40 * 40; ++i) {
    const double x = rng.uniform(), y = rng.uniform();
    even.push_back({700000000 + std::llround(40000 * x), 660000000 + std::llround(40000 * y), 0});
    falling.push_back({700000000 + std::llround(1000 / (1 - 0.975 * x)), 660000000 + std::llround(40000 * y), 0});
  }
  const PointDensity above = point_density(test::CloudStore(even).store(), {});
  const PointDensity around = point_density(test::CloudStore(falling).store(), {});
  EXPECT_LT(above.spread, 3);
  EXPECT_EQ(view_of(above), StreetView::air);
  EXPECT_GT(around.spread, 20);
  EXPECT_EQ(view_of(around), StreetView::street);
}

TEST(StreetTiles, PixelsForDensities) {
  EXPECT_EQ(pixel_for(1400, StreetView::street), 0.05);
  EXPECT_EQ(pixel_for(20, StreetView::street), 0.05 * 3);
  EXPECT_EQ(pixel_for(30, StreetView::air), 0.05 * 6);  // 30 points in 0.09 m2: 2.7 a pixel
  EXPECT_EQ(pixel_for(1, StreetView::air), 1);          // the coarsest
  EXPECT_EQ(pixel_for(2000, StreetView::air), 0.05);
}

}  // namespace
}  // namespace ilot
