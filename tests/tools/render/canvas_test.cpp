// SPDX-License-Identifier: Apache-2.0
#include "tools/render/canvas.h"

#include <gtest/gtest.h>

namespace ilot::render {
namespace {

constexpr Rgb kRed{200, 0, 0}, kGreen{0, 200, 0}, kWhite{255, 255, 255};

TEST(Canvas, TheNearestPointOfAPixelWins) {
  Canvas canvas(3, 3);
  canvas.draw(1, 1, 5, kRed, 0);
  canvas.draw(1, 1, 4, kGreen, 0);
  canvas.draw(0, 0, 4, kRed, 0);
  canvas.draw(0, 0, 5, kGreen, 0);
  const Image image = canvas.shaded(1e9);
  EXPECT_EQ(image.pixels[4], kRed);
  EXPECT_EQ(image.pixels[0], kGreen);
  EXPECT_EQ(image.pixels[8], kWhite);
}

TEST(Canvas, CutsWhatSticksOut) {
  Canvas canvas(2, 2);
  canvas.draw(-1, -1, 1, kRed, 1);
  canvas.draw(100, -100, 1, kRed, 3);
  const Image image = canvas.shaded(1e9);
  EXPECT_EQ(image.pixels[0], kRed);
  EXPECT_EQ(image.pixels[1], kWhite);
}

TEST(Canvas, DarkensWhereNeighboursStandNearer) {
  Canvas canvas(9, 1);
  for (int x = 0; x < 9; ++x) canvas.draw(x, 0, x < 4 ? 10.0f : 0.0f, kRed, 0);
  const Image image = canvas.shaded(1);
  EXPECT_EQ(image.pixels[8], kRed);
  EXPECT_LT(image.pixels[4][0], 180);
  EXPECT_EQ(image.pixels[3], kRed);
}

TEST(Canvas, ViewsHaveRightHandedAxes) {
  const ViewAxes top = axes_of({0, 90});
  EXPECT_NEAR(top.right.x, 1, 1e-12);
  EXPECT_NEAR(top.up.y, 1, 1e-12);
  EXPECT_NEAR(top.towards.z, 1, 1e-12);
  for (double azimuth : {0.0, 30.0, 200.0})
    for (double elevation : {0.0, 40.0, 90.0}) {
      const ViewAxes a = axes_of({azimuth, elevation});
      const Vec3 third = cross(a.right, a.up);
      EXPECT_NEAR(norm(third - a.towards), 0, 1e-12);
      EXPECT_NEAR(norm(a.right), 1, 1e-12);
    }
}

}  // namespace
}  // namespace ilot::render
