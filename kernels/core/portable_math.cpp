// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/portable_math.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace ilot {
namespace {

// Derived: pi / 180.
constexpr double kRadian = 0.017453292519943295;
// Derived: the natural logarithm of 2.
constexpr double kLog2 = 0.69314718055994531;
// The leading 32 bits of kLog2, whose product with a small integer is exact, and the rest.
constexpr double kLog2High = 0x1.62e42feep-1, kLog2Low = 0x1.a39ef35793c76p-33;

// Taylor series for |x| <= pi / 4.
double cos_series(double x) {
  const double s = x * x;
  double term = 1, sum = 1;
  for (int i = 1; i <= 10; ++i) {
    term *= -s / ((2 * i - 1) * (2 * i));
    sum += term;
  }
  return sum;
}

double sin_series(double x) {
  const double s = x * x;
  double term = x, sum = x;
  for (int i = 1; i <= 10; ++i) {
    term *= -s / ((2 * i) * (2 * i + 1));
    sum += term;
  }
  return sum;
}

// For t from 0 to 1. The angle is halved until the Taylor series is short.
double arctangent(double t) {
  constexpr int kHalvings = 3;
  for (int i = 0; i < kHalvings; ++i) t = t / (1 + std::sqrt(1 + t * t));  // below 0.1
  double power = t, sum = 0;
  for (int i = 1; i <= 17; i += 2) {
    sum += (i % 4 == 1 ? power : -power) / i;
    power *= t * t;
  }
  return (1 << kHalvings) * sum;
}

}  // namespace

double cos_degrees(double degrees) {
  const double within = std::fmod(degrees, 360.0);  // exact by definition, so the same on every machine
  const double turns = std::nearbyint(within / 90);
  const double rest = (within - 90 * turns) * kRadian;
  const auto quadrant = static_cast<std::int64_t>(turns) & 3;
  switch (quadrant) {
    case 0:
      return cos_series(rest);
    case 1:
      return -sin_series(rest);
    case 2:
      return -cos_series(rest);
    default:
      return sin_series(rest);
  }
}

double degrees_of_cosine(double c) {
  double low = 0, high = 90;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (cos_degrees(middle) >= c ? low : high) = middle;
  }
  return c >= 1 ? 0 : c <= 0 ? 90 : low;
}

double natural_log(double v) {
  const auto bits = std::bit_cast<std::uint64_t>(v);
  auto exponent = static_cast<std::int64_t>(bits >> 52 & 0x7ff) - 1023;
  double mantissa = std::bit_cast<double>((bits & 0xfffffffffffffull) | 0x3ff0000000000000ull);
  if (mantissa > 1.4142135623730951) {
    mantissa /= 2;
    ++exponent;
  }
  const double t = (mantissa - 1) / (mantissa + 1);  // |t| < 0.172
  const double s = t * t;
  double power = t, sum = 0;
  for (int i = 1; i <= 23; i += 2) {
    sum += power / i;
    power *= s;
  }
  return 2 * sum + static_cast<double>(exponent) * kLog2;
}

double natural_exp(double v) {
  if (v < -700) return 0;
  const double turns = std::nearbyint(v / kLog2);
  const double rest = (v - turns * kLog2High) - turns * kLog2Low;  // |rest| < 0.35
  double term = 1, sum = 1;
  for (int i = 1; i <= 16; ++i) {
    term *= rest / i;
    sum += term;
  }
  return std::ldexp(sum, static_cast<int>(turns));
}

double direction_degrees(double x, double y) {
  const double across = std::abs(x), up = std::abs(y);
  if (across == 0 && up == 0) return 0;
  const double degrees = arctangent(std::min(across, up) / std::max(across, up)) / kRadian;
  const double quadrant = up <= across ? degrees : 90 - degrees;
  const double half = x >= 0 ? quadrant : 180 - quadrant;
  return y >= 0 || half == 0 ? half : 360 - half;
}

}  // namespace ilot
