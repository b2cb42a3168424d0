// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/exact_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ilot::scan {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(ExactMath, AgreesWithTheMathematicsLibrary) {
  for (double degrees = -180; degrees <= 180; degrees += 0.37) {
    const SinCos angle = sin_cos_deg(degrees);
    EXPECT_NEAR(angle.sin, std::sin(degrees * kDegree), 1e-12);
    EXPECT_NEAR(angle.cos, std::cos(degrees * kDegree), 1e-12);
  }
  for (double degrees = -80; degrees <= 80; degrees += 0.7)
    EXPECT_NEAR(tan_deg(degrees) / std::tan(degrees * kDegree), 1, 1e-9);
  for (double tangent = -1; tangent <= 1; tangent += 0.013)
    EXPECT_NEAR(atan_deg(tangent), std::atan(tangent) / kDegree, 1e-9);
}

TEST(ExactMath, GaussianHasTheMomentsOfANormalNumber) {
  Rng rng(4);
  const int n = 200000;
  double sum = 0, squares = 0, fourth = 0;
  int beyond_two = 0;
  for (int i = 0; i < n; ++i) {
    const double g = gaussian(rng);
    ASSERT_LT(std::abs(g), 6);
    sum += g;
    squares += g * g;
    fourth += g * g * g * g;
    beyond_two += std::abs(g) > 2;
  }
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 2.9, 0.1);  // 3 - 1.2 / 12 for the sum of twelve uniform numbers
  EXPECT_NEAR(static_cast<double>(beyond_two) / n, 0.0455, 0.003);
}

}  // namespace
}  // namespace ilot::scan
