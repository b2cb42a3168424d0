// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/portable_math.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr long double kRadian = 3.14159265358979323846264338327950288L / 180;

// Oracle: the extended-precision library on the angle reduced exactly.
double true_cosine(double degrees) {
  return static_cast<double>(std::cos(static_cast<long double>(std::fmod(degrees, 360.0)) * kRadian));
}

TEST(PortableMath, CosineIsExactAtQuarterTurns) {
  for (int turn = -5; turn <= 5; ++turn) {
    EXPECT_EQ(cos_degrees(360.0 * turn), 1);
    EXPECT_EQ(cos_degrees(360.0 * turn + 90), 0);
    EXPECT_EQ(cos_degrees(360.0 * turn + 180), -1);
    EXPECT_EQ(cos_degrees(360.0 * turn + 270), 0);
  }
}

TEST(PortableMath, CosineStaysWithinItsError) {
  for (int i = -720000; i <= 720000; i += 7) {
    const double degrees = i / 1000.0;
    ASSERT_NEAR(cos_degrees(degrees), true_cosine(degrees), 1e-15) << degrees;
  }
  Rng rng(1);
  for (int i = 0; i < 20000; ++i) {
    const double degrees = (rng.uniform() - 0.5) * std::ldexp(1.0, static_cast<int>(rng.below(60)));
    ASSERT_NEAR(cos_degrees(degrees), true_cosine(degrees), 1e-15) << degrees;
  }
}

TEST(PortableMath, CosineOfAnyFiniteValueAndItsSymmetries) {
  for (const double degrees : {1e15, 1e17, 1e22, 1e100, DBL_MAX})
    EXPECT_NEAR(cos_degrees(degrees), true_cosine(degrees), 1e-15) << degrees;
  for (const double degrees : {0.0, DBL_MIN, 1e-9, 25.0, 45.0, 89.999, 1e17}) {
    EXPECT_EQ(cos_degrees(degrees), cos_degrees(-degrees));
    EXPECT_LE(std::abs(cos_degrees(degrees)), 1);
  }
}

TEST(PortableMath, CosineFallsFromZeroTo180) {
  double last = 1;
  for (int i = 1; i <= 18000; ++i) {
    const double c = cos_degrees(i / 100.0);
    ASSERT_LT(c, last) << i;
    last = c;
  }
}

TEST(PortableMath, LogarithmStaysWithinItsRelativeError) {
  EXPECT_EQ(natural_log(1), 0);
  Rng rng(2);
  const auto check = [](double v) {
    const auto wanted = static_cast<double>(std::log(static_cast<long double>(v)));
    ASSERT_NEAR(natural_log(v), wanted, 1e-14 * std::abs(wanted)) << v;
  };
  for (int i = 0; i < 50000; ++i) check(std::ldexp(1 + rng.uniform(), static_cast<int>(rng.below(2045)) - 1022));
  for (int bits = 1; bits <= 52; ++bits) {  // around 1, where the result vanishes
    check(1 + std::ldexp(1.0, -bits));
    check(1 - std::ldexp(1.0, -bits));
  }
  for (const double v : {DBL_MIN, DBL_MAX, 2.0, 0.5, std::sqrt(2.0), std::sqrt(0.5), 0.01, 1e-300}) check(v);
}

TEST(PortableMath, ExponentialsAreTheLibrarysToRounding) {
  for (double v = -699; v < 700; v += 0.37) EXPECT_NEAR(natural_exp(v) / std::exp(v), 1, 1e-14) << v;
  EXPECT_EQ(natural_exp(0), 1);
  EXPECT_EQ(natural_exp(-1000), 0);
}

TEST(PortableMath, DirectionsAreExactAlongTheAxes) {
  EXPECT_EQ(direction_degrees(2, 0), 0);
  EXPECT_EQ(direction_degrees(0, 2), 90);
  EXPECT_EQ(direction_degrees(-2, 0), 180);
  EXPECT_EQ(direction_degrees(0, -2), 270);
  EXPECT_EQ(direction_degrees(0, 0), 0);
  EXPECT_EQ(direction_degrees(3, -0.0), 0);
}

TEST(PortableMath, DirectionsStayWithinTheirError) {
  for (int i = 0; i < 36000; ++i) {
    const long double angle = i * kRadian / 100;
    const auto x = static_cast<double>(std::cos(angle)), y = static_cast<double>(std::sin(angle));
    long double wanted = std::atan2(static_cast<long double>(y), static_cast<long double>(x)) / kRadian;
    if (wanted < 0) wanted += 360;
    ASSERT_NEAR(direction_degrees(7 * x, 7 * y), static_cast<double>(wanted), 1e-12) << i;
    ASSERT_LT(direction_degrees(x, y), 360);
  }
}

TEST(PortableMath, DegreesOfACosineTurnItRound) {
  EXPECT_EQ(degrees_of_cosine(1), 0);
  EXPECT_EQ(degrees_of_cosine(1.5), 0);
  EXPECT_EQ(degrees_of_cosine(0), 90);
  EXPECT_EQ(degrees_of_cosine(-0.5), 90);
  EXPECT_NEAR(degrees_of_cosine(0.5), 60, 1e-12);
  for (double angle = 0.5; angle < 90; angle += 0.5) EXPECT_NEAR(degrees_of_cosine(cos_degrees(angle)), angle, 1e-11);
}

}  // namespace
}  // namespace ilot
