// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/trend_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/products/facades/openings/wall_cells.h"
#include "engine/products/facades/openings/wall_means.h"
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
// Choice: leaves, doors and most shop fronts are lower and narrower; a spandrel or a pier of several storeys goes on.
constexpr double kLongRun = 3;  // metres
// Choice: as kOnePlate in flat_plates.cpp: within it the wall goes on.
constexpr double kOneSurface = 0.01;  // metres between neighbouring cells
// Derived: the difference of two means of four points has a standard deviation of 0.7 of that of a point; two of them.
constexpr double kOneSurfaceOfNoise = 1.4;  // times the noise
// Derived: as kRiseOfNoise in flat_plates.cpp: leaves that stand out less cannot be distinguished from the wall.
constexpr double kApartOfNoise = 3;      // times the scatter of the wall
constexpr double kMostOnLongRuns = 0.5;  // Derived: a majority; share of the points of leaves
// Choice: leaves with surrounds leave a fifth of a storey at the least; half of that, since a scan is uneven.
constexpr double kLeastAtWall = 0.1;        // share of the points of a strip
constexpr double kNormalOfMedian = 1.4826;  // Derived: standard deviation over median distance, normal noise

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

// The form of some points, from the plane of the wall on.
TrendSurface form_of(const RaySamples& samples, const std::vector<FormPoint>& points) {
  TrendSurface form;
  form.width = samples.site().width, form.height = samples.site().height;
  if (points.size() < kFewestForForm || !(form.width > 0) || !(form.height > 0)) return form;
  for (int round = 0; round < kFormRounds; ++round)
    if (!fit_again(points, form)) return form;
  form.found = true;
  return form;
}

// The mean distance from the plane of the points about each cell of a wall; not a number without any.
std::vector<double> mean_distances(const RaySamples& samples, const WallCells& cells) {
  std::vector<double> mean(cells.what.size(), 0);
  std::vector<std::uint32_t> count(cells.what.size(), 0);
  for (const Ray& ray : samples.all()) {
    const double u = ray.at.u, v = ray.at.v, w = ray.at.w;
    if (std::abs(w) > kFormReach || u < 0 || v < 0) continue;
    const auto c = static_cast<std::int64_t>(u / cells.cell), r = static_cast<std::int64_t>(v / cells.cell);
    if (c >= cells.columns || r >= cells.rows) continue;
    const auto i = static_cast<std::size_t>(r * cells.columns + c);
    mean[i] += w, ++count[i];
  }
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] /= count[i];
  return mean;
}

// Marks the cells of one row or column that belong to long runs: cells in which the surface goes on from one to the
// next. Cells without points neither end a run nor lengthen it.
void mark_long_runs(const std::vector<double>& mean, std::size_t first, std::size_t by, std::size_t length,
                    double within, std::size_t fewest, std::vector<bool>& is_long) {
  std::vector<std::size_t> run;
  const auto end_run = [&] {
    if (run.size() >= fewest)
      for (const std::size_t i : run) is_long[i] = true;
    run.clear();
  };
  for (std::size_t k = 0; k < length; ++k) {
    const std::size_t i = first + k * by;
    if (std::isnan(mean[i])) continue;
    if (!run.empty() && std::abs(mean[i] - mean[run.back()]) > within) end_run();
    run.push_back(i);
  }
  end_run();
}

// The points of surfaces that go on over more than the size of a window, along the wall or upwards. Joints between
// stones go on too, but are narrower than a post.
std::vector<FormPoint> points_of_long_runs(const RaySamples& samples, const std::vector<FormPoint>& points) {
  const WallCells cells = wall_grid(samples.site());
  const std::vector<double> mean = mean_distances(samples, cells);
  const double within = std::max(kOneSurface, kOneSurfaceOfNoise * samples.site().noise);
  const auto fewest = static_cast<std::size_t>(kLongRun / cells.cell) + 1;
  const auto columns = static_cast<std::size_t>(cells.columns), rows = static_cast<std::size_t>(cells.rows);
  std::vector<bool> is_long(mean.size(), false);
  for (std::size_t r = 0; r < rows; ++r) mark_long_runs(mean, r * columns, 1, columns, within, fewest, is_long);
  for (std::size_t c = 0; c < columns; ++c) mark_long_runs(mean, c, columns, rows, within, fewest, is_long);
  is_long.flip();
  const auto post = static_cast<std::int64_t>(std::ceil(kWidestBar / cells.cell));
  is_long = covered_by_squares(cells, is_long, post, 0);
  std::vector<FormPoint> kept;
  for (const FormPoint& p : points) {
    const auto c = static_cast<std::size_t>(p.u / cells.cell), r = static_cast<std::size_t>(p.v / cells.cell);
    if (c < columns && r < rows && is_long[r * columns + c]) kept.push_back(p);
  }
  return kept;
}

// How far one form stands before another in the mean.
double mean_before(const TrendSurface& a, const TrendSurface& b) {
  // Derived: the integral of a second-degree form over the wall is that of its terms; the mean of x * x is 1/12.
  std::array<double, kTerms> d{};
  for (std::size_t i = 0; i < kTerms; ++i) d[i] = a.terms[i] - b.terms[i];
  return d[0] + (d[3] + d[5]) / 12;
}

// How many points lie nearer to a form than to the one behind it.
std::size_t points_before(const std::vector<FormPoint>& points, const TrendSurface& form, const TrendSurface& behind) {
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const FormPoint& p) {
    return p.w > (form.at(p.u, p.v) + behind.at(p.u, p.v)) / 2;
  }));
}

// Whether two forms lie nowhere farther apart than leaves stand out. A form that few places carry swings elsewhere.
bool lie_close(const TrendSurface& a, const TrendSurface& b) {
  for (const double u : {0.0, a.width / 2, a.width})
    for (const double v : {0.0, a.height / 2, a.height})
      if (std::abs(a.at(u, v) - b.at(u, v)) > kFlatRelief) return false;
  return true;
}

// Whether a form shows everywhere: in every strip of the wall that is as wide as a long run there are points near it.
// The wall behind leaves shows above, below and beside each of them; a house that stands farther back does not.
bool shows_everywhere(const std::vector<FormPoint>& points, const TrendSurface& form, double within, bool along_wall) {
  struct Strip {
    std::size_t near = 0, all = 0;
  };
  const double length = along_wall ? form.width : form.height;
  std::vector<Strip> strips(std::max<std::size_t>(1, static_cast<std::size_t>(length / kLongRun)));
  for (const FormPoint& p : points) {
    const double at = (along_wall ? p.u : p.v) / length * static_cast<double>(strips.size());
    Strip& strip = strips[std::min(static_cast<std::size_t>(at), strips.size() - 1)];
    ++strip.all, strip.near += std::abs(p.w - form.at(p.u, p.v)) < within;
  }
  return std::all_of(strips.begin(), strips.end(), [](const Strip& s) {
    return static_cast<double>(s.near) >= kLeastAtWall * static_cast<double>(s.all);
  });
}

}  // namespace

TrendSurface trend_surface(const RaySamples& samples) {
  const std::vector<FormPoint> points = form_points(samples);
  const TrendSurface form = form_of(samples, points);
  if (!form.found) return form;
  const std::vector<FormPoint> long_runs = points_of_long_runs(samples, points);
  const TrendSurface behind = form_of(samples, long_runs);
  if (!behind.found) return form;
  const double out = mean_before(form, behind), scatter = std::max(kModeBin, behind.noise);
  if (out <= std::max(kLeastStep, kApartOfNoise * scatter) || !lie_close(form, behind)) return form;
  const double within = std::min(out / 2, kFormKept * scatter);
  if (!shows_everywhere(points, behind, within, true) || !shows_everywhere(points, behind, within, false)) return form;
  // What stands before it is leaves where it ends; else it is a wall too, that of a house that stands farther out.
  const auto all = static_cast<double>(points_before(points, form, behind));
  return static_cast<double>(points_before(long_runs, form, behind)) < kMostOnLongRuns * all ? behind : form;
}

}  // namespace ilot
