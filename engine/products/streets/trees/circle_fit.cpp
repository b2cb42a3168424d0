// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/trees/circle_fit.h"

#include <cmath>

namespace ilot {
namespace {

constexpr int kSteps = 30;  // of Newton's method; five are usual

// Moments of centred points.
struct Moments {
  double xx = 0, yy = 0, xy = 0, xz = 0, yz = 0, zz = 0;
};

Moments moments_of(std::span<const CirclePoint> points, const CirclePoint& middle) {
  Moments m;
  for (const CirclePoint& p : points) {
    const double x = p.x - middle.x, y = p.y - middle.y, z = x * x + y * y;
    m.xx += x * x, m.yy += y * y, m.xy += x * y, m.xz += x * z, m.yz += y * z, m.zz += z * z;
  }
  const auto n = static_cast<double>(points.size());
  return {m.xx / n, m.yy / n, m.xy / n, m.xz / n, m.yz / n, m.zz / n};
}

// The smallest root of Taubin's polynomial, by Newton's method from 0.
double smallest_root(const Moments& m) {
  const double z = m.xx + m.yy, cov = m.xx * m.yy - m.xy * m.xy, var = m.zz - z * z;
  const double a3 = 4 * z, a2 = -3 * z * z - m.zz;
  const double a1 = var * z + 4 * cov * z - m.xz * m.xz - m.yz * m.yz;
  const double a0 = m.xz * (m.xz * m.yy - m.yz * m.xy) + m.yz * (m.yz * m.xx - m.xz * m.xy) - var * cov;
  double x = 0, y = a0;
  for (int i = 0; i < kSteps; ++i) {
    const double slope = a1 + x * (2 * a2 + 3 * a3 * x);
    const double next = x - y / slope;
    if (next == x || !std::isfinite(next)) break;
    const double value = a0 + next * (a1 + next * (a2 + next * a3));
    if (std::abs(value) >= std::abs(y)) break;
    x = next, y = value;
  }
  return x;
}

}  // namespace

Circle fit_circle(std::span<const CirclePoint> points) {
  if (points.size() < 4) return {};
  CirclePoint middle;
  for (const CirclePoint& p : points) middle.x += p.x, middle.y += p.y;
  middle.x /= static_cast<double>(points.size()), middle.y /= static_cast<double>(points.size());
  const Moments m = moments_of(points, middle);
  const double root = smallest_root(m), z = m.xx + m.yy;
  const double det = root * root - root * z + m.xx * m.yy - m.xy * m.xy;
  // Derived: points whose spread across their line is a thousandth of that along it are on a line.
  if (!(std::abs(det) > 1e-6 * z * z)) return {};
  const double x = (m.xz * (m.yy - root) - m.yz * m.xy) / det / 2;
  const double y = (m.yz * (m.xx - root) - m.xz * m.xy) / det / 2;
  return {x + middle.x, y + middle.y, std::sqrt(x * x + y * y + z)};
}

}  // namespace ilot
