// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/circle_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

std::vector<PlanePoint> arc(double x, double y, double radius, double from, double to, double noise) {
  Rng rng(9);
  std::vector<PlanePoint> points;
  for (int i = 0; i <= 60; ++i) {
    const double angle = from + (to - from) * i / 60, r = radius + noise * (2 * rng.uniform() - 1);
    points.push_back({x + r * cos_degrees(angle), y + r * cos_degrees(angle - 90)});
  }
  return points;
}

TEST(CircleFit, ExactOnACircle) {
  for (const double shift : {0.0, 650000.0}) {
    const CircleFit fit = fit_circle(arc(shift + 2, -3, 1.05, 20, 160, 0));
    ASSERT_TRUE(fit.found);
    EXPECT_NEAR(fit.centre.x, shift + 2, 1e-7);
    EXPECT_NEAR(fit.centre.y, -3, 1e-7);
    EXPECT_NEAR(fit.radius, 1.05, 1e-7);
    EXPECT_LT(fit.rms, 1e-7);
  }
}

TEST(CircleFit, NoiseAveragesOut) {
  const CircleFit fit = fit_circle(arc(0, 0, 1.05, 10, 170, 0.004));
  ASSERT_TRUE(fit.found);
  EXPECT_NEAR(fit.radius, 1.05, 0.002);
  EXPECT_NEAR(fit.rms, 0.004 / std::sqrt(3.0), 0.0008);
}

// The algebraic fit alone is drawn inwards on short arcs with noise.
TEST(CircleFit, ShortArcsKeepTheirRadius) {
  const CircleFit fit = fit_circle(arc(1, 6.3549, 1.1751, 57.9, 122.1, 0.001));
  ASSERT_TRUE(fit.found);
  EXPECT_NEAR(fit.radius, 1.1751, 0.01);
}

TEST(CircleFit, LinesAreNone) {
  EXPECT_FALSE(fit_circle(std::vector<PlanePoint>{{0, 0}, {1, 1}, {2, 2}, {5, 5}}).found);
  EXPECT_FALSE(fit_circle(std::vector<PlanePoint>{{0, 0}, {1, 1}}).found);
  EXPECT_FALSE(fit_circle(std::vector<PlanePoint>{{1, 1}, {1, 1}, {1, 1}}).found);
}

}  // namespace
}  // namespace ilot
