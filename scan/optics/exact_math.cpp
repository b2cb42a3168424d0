// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Uses the Taylor series. |x| <= pi/8, so ten terms leave an error below 1e-18.
SinCos small_angle(double x) {
  double sine = 0, cosine = 0, term = 1;
  for (int k = 0; k < 20; ++k) {
    const double sign = (k / 2) % 2 == 0 ? 1 : -1;
    (k % 2 == 0 ? cosine : sine) += sign * term;
    term = term * x / (k + 1);
  }
  return {sine, cosine};
}

}  // namespace

SinCos sin_cos_deg(double degrees) {
  SinCos angle = small_angle(degrees * kPi / 180 / 8);
  for (int doubling = 0; doubling < 3; ++doubling)
    angle = {2 * angle.sin * angle.cos, angle.cos * angle.cos - angle.sin * angle.sin};
  return angle;
}

double tan_deg(double degrees) {
  const SinCos angle = sin_cos_deg(degrees);
  return angle.sin / angle.cos;
}

double atan_deg(double tangent) {
  // Newton steps on f(a) = sin(a) - tangent cos(a), whose derivative is close to sqrt(1 + tangent^2).
  double degrees = tangent * (180 / kPi) / (1 + 0.28 * tangent * tangent);
  for (int step = 0; step < 3; ++step) {
    const SinCos angle = sin_cos_deg(degrees);
    const double slope = angle.cos + tangent * angle.sin;
    degrees -= (angle.sin - tangent * angle.cos) / slope * (180 / kPi);
  }
  return degrees;
}

double gaussian(Rng& rng) {
  std::uint64_t sum = 0;
  for (int draw = 0; draw < 3; ++draw) {
    const std::uint64_t bits = rng.next();
    sum += (bits & 0xffff) + ((bits >> 16) & 0xffff) + ((bits >> 32) & 0xffff) + (bits >> 48);
  }
  // Each of the twelve terms has mean 32767.5 and variance (2^32 - 1) / 12.
  return (static_cast<double>(sum) - 12 * 32767.5) * 0x1p-16;
}

}  // namespace ilot::scan
