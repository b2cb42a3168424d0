// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/circle_fit.h"

#include <array>
#include <cmath>
#include <utility>

namespace ilot {
namespace {

using Row = std::array<double, 4>;  // of three equations, the right side last

// Solves by elimination with pivots. Returns false when the equations have no unique solution.
bool solve(std::array<Row, 3> m, std::array<double, 3>& x) {
  // Derived: far above the rounding of doubles, far below any circle that is seen.
  constexpr double kSingular = 1e-12;
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < 3; ++r)
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    if (!(std::abs(m[pivot][c]) > kSingular)) return false;
    std::swap(m[c], m[pivot]);
    for (std::size_t r = c + 1; r < 3; ++r) {
      const double f = m[r][c] / m[c][c];
      for (std::size_t k = c; k < 4; ++k) m[r][k] -= f * m[c][k];
    }
  }
  for (std::size_t c = 3; c-- > 0;) {
    x[c] = m[c][3];
    for (std::size_t k = c + 1; k < 3; ++k) x[c] -= m[c][k] * x[k];
    x[c] /= m[c][c];
  }
  return true;
}

void add(std::array<Row, 3>& m, const std::array<double, 3>& a, double b) {
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) m[r][c] += a[r] * a[c];
    m[r][3] += a[r] * b;
  }
}

}  // namespace

CircleFit fit_circle(std::span<const PlanePoint> points) {
  constexpr int kRounds = 20;
  if (points.size() < 3) return {};
  const auto n = static_cast<double>(points.size());
  double mx = 0, my = 0, size = 0;
  for (const PlanePoint& p : points) mx += p.x / n, my += p.y / n;
  for (const PlanePoint& p : points) size += ((p.x - mx) * (p.x - mx) + (p.y - my) * (p.y - my)) / n;
  const double scale = std::sqrt(size);
  if (!(scale > 0)) return {};
  // The units are the spread of the points about their middle: x^2 + y^2 = 2 a x + 2 b y + c.
  std::array<Row, 3> normal{};
  std::array<double, 3> v{};
  for (const PlanePoint& p : points) {
    const double x = (p.x - mx) / scale, y = (p.y - my) / scale;
    add(normal, {2 * x / std::sqrt(n), 2 * y / std::sqrt(n), 1 / std::sqrt(n)}, (x * x + y * y) / std::sqrt(n));
  }
  if (!solve(normal, v)) return {};
  double a = v[0], b = v[1], r = std::sqrt(std::max(0.0, v[2] + a * a + b * b));
  for (int round = 0; round < kRounds; ++round) {
    std::array<Row, 3> m{};
    for (const PlanePoint& p : points) {
      const double x = (p.x - mx) / scale - a, y = (p.y - my) / scale - b, d = std::sqrt(x * x + y * y);
      if (d > 0) add(m, {x / d, y / d, 1}, d - r);
    }
    if (!solve(m, v)) return {};
    a += v[0], b += v[1], r += v[2];
    if (std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]) < 1e-13) break;
  }
  CircleFit fit{{mx + a * scale, my + b * scale}, r * scale, 0, true};
  for (const PlanePoint& p : points) {
    const double x = p.x - fit.centre.x, y = p.y - fit.centre.y, off = std::sqrt(x * x + y * y) - fit.radius;
    fit.rms += off * off / n;
  }
  fit.rms = std::sqrt(fit.rms);
  fit.found = std::isfinite(fit.rms) && fit.radius > 0;
  return fit;
}

}  // namespace ilot
