// SPDX-License-Identifier: Apache-2.0
#include "training/f_distribution.h"

#include <cassert>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kHalfLogPi = 0.57236494292470009;  // log of gamma(1/2)

// Logarithm of gamma(n / 2), n >= 1, by its recurrence.
double log_gamma_of_half(std::uint32_t n) {
  double sum = n % 2 == 1 ? kHalfLogPi : 0;
  double product = 1;  // logarithms of many factors at once
  for (std::uint32_t m = n % 2 == 1 ? 1 : 2; m < n; m += 2) {
    product *= 0.5 * m;
    if (product < 1e280) continue;
    sum += natural_log(product);
    product = 1;
  }
  return sum + natural_log(product);
}

double away_from_zero(double v) {
  constexpr double kTiny = 1e-300;
  return std::abs(v) < kTiny ? kTiny : v;
}

// Continued fraction of the incomplete beta function. It converges fast for x < (a + 1) / (a + b + 2).
double beta_fraction(double a, double b, double x) {
  double c = 1, d = 1 / away_from_zero(1 - (a + b) * x / (a + 1)), value = d;
  for (int m = 1; m <= 10000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / away_from_zero(1 + even * d);
    c = away_from_zero(1 + even / c);
    value *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / away_from_zero(1 + odd * d);
    c = away_from_zero(1 + odd / c);
    value *= d * c;
    if (std::abs(d * c - 1) < 1e-15) break;
  }
  return value;
}

}  // namespace

double f_upper_tail(double f, std::uint32_t d1, std::uint32_t d2) {
  assert(d1 >= 1 && d2 >= 1);
  if (!(f > 0)) return 1;
  // The result is I_x(a, b) with a = d2 / 2, b = d1 / 2. x and 1 - x are computed separately, without cancellation.
  const double a = 0.5 * d2, b = 0.5 * d1, whole = d2 + d1 * f;
  const double x = d2 / whole, rest = d1 * f / whole;
  if (x < 1e-300) return 0;
  const double log_factor = a * natural_log(x) + b * natural_log(rest) + log_gamma_of_half(d1 + d2) -
                            log_gamma_of_half(d1) - log_gamma_of_half(d2);
  const double factor = natural_exp(log_factor);
  if (x < (a + 1) / (a + b + 2)) return factor * beta_fraction(a, b, x) / a;
  return 1 - factor * beta_fraction(b, a, rest) / b;
}

}  // namespace ilot
