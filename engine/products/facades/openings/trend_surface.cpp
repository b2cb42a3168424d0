// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/trend_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr std::size_t kTerms = 6;
// Choice: walls of old houses bow and lean by up to 3 cm from their mean plane, and panes lie as far behind them.
constexpr double kFormReach = 0.08;  // metres from the plane in which points may belong to the wall
// Choice: half of the noise of a good scanner.
constexpr double kModeBin = 0.002;  // metres
// Derived: 98.8 % of normal noise.
constexpr double kFormKept = 2.5;  // standard deviations from the most frequent distance
// Choice: the plane is right to some centimetres and each round halves what is left.
constexpr int kFormRounds = 6;
constexpr std::size_t kFewestForForm = 200;      // points; of fewer the form is that of the noise
constexpr std::uint64_t kMostForForm = 1 << 15;  // more points do not improve the form
constexpr double kNormalOfMedian = 1.4826;       // Derived: standard deviation over median distance, normal noise

struct FormPoint {
  double u, v, w;
};

std::array<double, kTerms> powers(const TrendSurface& form, const FormPoint& p) {
  const double x = p.u / form.width - 0.5, y = p.v / form.height - 0.5;
  return {1, x, y, x * x, x * y, y * y};
}

// Solves the normal equations by Cholesky's method; false where they are singular.
bool solve(std::array<std::array<double, kTerms>, kTerms>& a, std::array<double, kTerms>& b) {
  for (std::size_t i = 0; i < kTerms; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      double sum = a[i][k];
      for (std::size_t j = 0; j < k; ++j) sum -= a[i][j] * a[k][j];
      if (i == k && !(sum > 0)) return false;
      a[i][k] = i == k ? std::sqrt(sum) : sum / a[k][k];
    }
    for (std::size_t j = 0; j < i; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  for (std::size_t i = kTerms; i-- > 0;) {
    for (std::size_t j = i + 1; j < kTerms; ++j) b[i] -= a[j][i] * b[j];
    b[i] /= a[i][i];
  }
  return true;
}

// The most frequent distance from the form, to a bin.
double mode_of(const std::vector<double>& off) {
  const auto bins = static_cast<std::size_t>(2 * kFormReach / kModeBin) + 1;
  std::vector<std::size_t> count(bins + 4, 0);
  for (const double d : off)
    if (std::abs(d) < kFormReach) ++count[static_cast<std::size_t>((d + kFormReach) / kModeBin) + 2];
  std::size_t best = 2, most = 0;
  for (std::size_t b = 2; b + 2 < count.size(); ++b) {  // five bins: the noise of a scanner is wider than one
    const std::size_t sum = count[b - 2] + count[b - 1] + count[b] + count[b + 1] + count[b + 2];
    if (sum > most) most = sum, best = b;
  }
  return (static_cast<double>(best) - 1.5) * kModeBin - kFormReach;
}

// The standard deviation of the points that lie before the mode; 0 for too few.
double scatter_before(const std::vector<double>& off, double mode) {
  std::vector<double> before;
  for (const double d : off)
    if (d >= mode && d < mode + kFormReach / 2) before.push_back(d - mode);
  return before.size() < kFewestForForm / 4 ? 0 : kNormalOfMedian * upper_median(before);
}

std::vector<FormPoint> form_points(const RaySamples& samples) {
  const FacadeSite& site = samples.site();
  const auto counts = [&](const Ray& ray) {
    return std::abs(static_cast<double>(ray.at.w)) <= kFormReach && ray.at.u >= 0 && ray.at.v >= 0 &&
           ray.at.u <= site.width && ray.at.v <= site.height;
  };
  Rays all = samples.all();
  const int level = thinning_level(all, kMostForForm, counts);
  std::vector<FormPoint> points;
  for (const Ray& ray : all)
    if (counts(ray) && is_kept(ray, level)) points.push_back({ray.at.u, ray.at.v, ray.at.w});
  return points;
}

// One round: the form of the points near the mode; false where it cannot be fitted.
bool fit_again(const std::vector<FormPoint>& points, TrendSurface& form) {
  std::vector<double> off;
  for (const FormPoint& p : points) off.push_back(p.w - form.at(p.u, p.v));
  const double mode = mode_of(off), scatter = std::max(kModeBin, scatter_before(off, mode));
  std::array<std::array<double, kTerms>, kTerms> a{};
  std::array<double, kTerms> b{};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(off[i] - mode) > kFormKept * scatter) continue;
    const std::array<double, kTerms> x = powers(form, points[i]);
    for (std::size_t r = 0; r < kTerms; ++r) {
      b[r] += x[r] * points[i].w;
      for (std::size_t c = 0; c <= r; ++c) a[r][c] += x[r] * x[c];
    }
    ++kept;
  }
  if (kept < kFewestForForm || !solve(a, b)) return false;
  form.terms = b;
  form.noise = scatter;
  return true;
}

}  // namespace

TrendSurface trend_surface(const RaySamples& samples) {
  const std::vector<FormPoint> points = form_points(samples);
  TrendSurface form;
  form.width = samples.site().width, form.height = samples.site().height;
  if (points.size() < kFewestForForm || !(form.width > 0) || !(form.height > 0)) return form;
  for (int round = 0; round < kFormRounds; ++round)
    if (!fit_again(points, form)) return form;
  form.found = true;
  return form;
}

}  // namespace ilot
