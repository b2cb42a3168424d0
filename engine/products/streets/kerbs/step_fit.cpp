// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/kerbs/step_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr std::size_t kAtOnce = 4;                           // directions that are tried at once
constexpr std::size_t kDirections = 16;                      // over half a turn
constexpr std::array<double, kAtOnce> kTurns{-6, -3, 3, 6};  // degrees, from the best of them
constexpr int kBins = 32;                                    // across the window
// Derived: points of the face of a kerb are this near to the edge (the width of two bins), where they would tilt
// planes.
constexpr double kFaceShare = 8;         // of the radius
constexpr std::size_t kLeastOfSide = 6;  // Derived: twice the unknowns of a plane
// Choice: ramps and lawns are steeper than streets; a kerb lies between surfaces that cars and people use.
constexpr double kSteepest = 0.35;  // rise over run, of a side
// Choice: a camber of 4 % meets a pavement that rises by 2 %; a ramp of a drive-way to 15 % is still taken.
constexpr double kMostBend = 0.25;  // difference of the slopes of both sides
// Derived: the height is the difference of two means, of at least six points each: noise of this share of the height
// makes it wrong by a quarter at most.
constexpr double kMostRough = 0.35;  // rms over height

using Vec = std::array<double, 3>;

// The symmetric normal equations of a plane z = a + b x + c y.
struct PlaneSums {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, z = 0, xz = 0, yz = 0;

  void add(const GroundPoint& p) {
    n += 1, x += p.x, y += p.y, xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y;
    z += p.z, xz += p.x * p.z, yz += p.y * p.z;
  }
};

// The inverse of the matrix of a plane's normal equations.
struct Inverse {
  double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;  // rows a b c, b d e, c e f
  bool known = false;

  explicit Inverse(const PlaneSums& s) {
    const double p = s.xx * s.yy - s.xy * s.xy, q = s.xy * s.y - s.x * s.yy, r = s.x * s.xy - s.xx * s.y;
    const double det = s.n * p + s.x * q + s.y * r;
    // Derived: points on a line make the determinant vanish; the bound is a width of a thousandth of the length.
    known = det > 1e-6 * s.n * (s.xx + s.yy) * (s.xx + s.yy);
    if (!known) return;
    a = p / det, b = q / det, c = r / det;
    d = (s.n * s.yy - s.y * s.y) / det, e = (s.x * s.y - s.n * s.xy) / det, f = (s.n * s.xx - s.x * s.x) / det;
  }
  Vec times(double u, double v, double w) const {
    return {a * u + b * v + c * w, b * u + d * v + e * w, c * u + e * v + f * w};
  }
  // The value of the quadratic form.
  double form(double u, double v, double w) const {
    const Vec t = times(u, v, w);
    return u * t[0] + v * t[1] + w * t[2];
  }
};

// Sums over the points on the upper side of a line.
struct Side {
  double n = 0, x = 0, y = 0, residual = 0;

  void add(const Side& other) { n += other.n, x += other.x, y += other.y, residual += other.residual; }
};

// How much less the squares are with a step along the line; the height of the step has the sign of `residual`.
double gain(const Inverse& inverse, const Side& up) {
  const double left = up.n - inverse.form(up.n, up.x, up.y);
  return left > 1e-9 ? up.residual * up.residual / left : 0;
}

struct Line {
  double up_x = 1, up_y = 0, t = 0;
  double gain = 0;
};

struct Direction {
  double ux = 1, uy = 0;
};
using Directions = std::array<Direction, kAtOnce>;

// The directions that are tried, each with those near it.
struct TriedDirections {
  std::array<Directions, kDirections / kAtOnce> all;
  std::array<Directions, kDirections> near;

  TriedDirections() {
    const auto towards = [](double degrees) { return Direction{cos_degrees(degrees), cos_degrees(degrees - 90)}; };
    for (std::size_t k = 0; k < kDirections; ++k) {
      const double degrees = 180.0 * static_cast<double>(k) / kDirections;
      all[k / kAtOnce][k % kAtOnce] = towards(degrees);
      for (std::size_t t = 0; t < kAtOnce; ++t) near[k][t] = towards(degrees + kTurns[t]);
    }
  }
};

class StepFinder {
 public:
  StepFinder(std::span<const GroundPoint> points, const StepFitParams& params) : points_(points), params_(params) {}

  std::optional<StepFit> find() {
    if (points_.size() < 2 * kLeastOfSide) return std::nullopt;
    PlaneSums all;
    for (const GroundPoint& p : points_) all.add(p);
    const Inverse inverse(all);
    if (!inverse.known) return std::nullopt;
    const Vec plane = inverse.times(all.z, all.xz, all.yz);
    residuals_.resize(points_.size());
    double squares = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      residuals_[i] = points_[i].z - plane[0] - plane[1] * points_[i].x - plane[2] * points_[i].y;
      squares += residuals_[i] * residuals_[i];
    }
    // Derived: points on both sides of a step of `lowest` have half of it as their least deviation from one plane, of
    // which a tilt takes away three quarters of the squares at most.
    if (squares < 0.0625 * params_.lowest * params_.lowest * static_cast<double>(points_.size())) return std::nullopt;
    static const TriedDirections tried;
    Line best;
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < tried.all.size(); ++k)
      if (const auto better = try_directions(tried.all[k], inverse, best)) nearest = k * kAtOnce + *better;
    try_directions(tried.near[nearest], inverse, best);
    if (best.gain == 0) return std::nullopt;
    return of_line(best);
  }

 private:
  using Bins = std::array<Side, kBins>;

  // The sums over the points of each bin across each direction. Points come in rows, so that one after the other is in
  // the same bin and waits for its sums; of several directions at once the others do not wait.
  std::array<Bins, kAtOnce> bins_across(const Directions& directions) const {
    std::array<Bins, kAtOnce> bins{};
    const double per = kBins / (2 * params_.radius);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const GroundPoint& p = points_[i];
      const Side own{1, p.x, p.y, residuals_[i]};
      for (std::size_t k = 0; k < kAtOnce; ++k) {
        const double t = p.x * directions[k].ux + p.y * directions[k].uy;
        const int bin = std::clamp(static_cast<int>((t + params_.radius) * per), 0, kBins - 1);
        bins[k][static_cast<std::size_t>(bin)].add(own);
      }
    }
    return bins;
  }

  // Returns the last of these directions across which a line is better than the best one.
  std::optional<std::size_t> try_directions(const Directions& directions, const Inverse& inverse, Line& best) const {
    const std::array<Bins, kAtOnce> bins = bins_across(directions);
    std::optional<std::size_t> better;
    for (std::size_t k = 0; k < kAtOnce; ++k)
      if (try_lines(directions[k], bins[k], inverse, best)) better = k;
    return better;
  }

  // Returns whether a line between two bins across the direction is better than the best one.
  bool try_lines(Direction d, const Bins& bins, const Inverse& inverse, Line& best) const {
    const double per = kBins / (2 * params_.radius);
    Side up;
    bool better = false;
    const auto all = static_cast<double>(points_.size());
    for (int b = kBins - 1; b > 0; --b) {
      const Side& bin = bins[static_cast<std::size_t>(b)];
      if (bin.n == 0) continue;  // the same sides as at the edge before
      up.add(bin);
      if (up.n < kLeastOfSide || all - up.n < kLeastOfSide) continue;
      const double g = gain(inverse, up);
      if (g <= best.gain * (1 + 1e-9)) continue;
      const double sign = up.residual > 0 ? 1 : -1, t = b / per - params_.radius;
      best = {sign * d.ux, sign * d.uy, sign * t, g};
      better = true;
    }
    return better;
  }

  // The step along a line: the edge between the points of both sides, and a plane on each of them.
  std::optional<StepFit> of_line(const Line& line) const {
    PlaneSums low, up;
    double last_low = -INFINITY, first_up = INFINITY;
    std::size_t far_low = 0, far_up = 0;
    const double third = params_.radius / 3, face = params_.radius / kFaceShare;
    for (const GroundPoint& p : points_) {
      const double t = p.x * line.up_x + p.y * line.up_y;
      if (t < line.t) {
        last_low = std::max(last_low, t), far_low += t < line.t - third;
        if (t < line.t - face) low.add(p);
      } else {
        first_up = std::min(first_up, t), far_up += t > line.t + third;
        if (t > line.t + face) up.add(p);
      }
    }
    if (low.n < kLeastOfSide || up.n < kLeastOfSide || far_low < 3 || far_up < 3) return std::nullopt;
    const Inverse low_inverse(low), up_inverse(up);
    if (!low_inverse.known || !up_inverse.known) return std::nullopt;
    const Vec a = low_inverse.times(low.z, low.xz, low.yz), b = up_inverse.times(up.z, up.xz, up.yz);
    if (std::hypot(a[1], a[2]) > kSteepest || std::hypot(b[1], b[2]) > kSteepest ||
        std::hypot(a[1] - b[1], a[2] - b[2]) > kMostBend)
      return std::nullopt;
    // The upper surface is seen up to its edge, from wherever; what is below the edge may be hidden by it. So the edge
    // is half a step of the points before the first of the upper side, and not below the middle of the gap.
    const double edge = std::max((last_low + first_up) / 2, first_up - params_.radius / (up.n + 1));
    StepFit fit;
    fit.up_x = line.up_x, fit.up_y = line.up_y;
    fit.x = edge * line.up_x, fit.y = edge * line.up_y;
    fit.z = b[0] + b[1] * fit.x + b[2] * fit.y;
    fit.height = fit.z - (a[0] + a[1] * fit.x + a[2] * fit.y);
    fit.rms = rms(line, a, b);
    if (fit.height < params_.lowest || fit.height > params_.highest || fit.rms > kMostRough * fit.height)
      return std::nullopt;
    return fit;
  }

  double rms(const Line& line, const Vec& low, const Vec& up) const {
    double squares = 0, n = 0;
    for (const GroundPoint& p : points_) {
      const double t = p.x * line.up_x + p.y * line.up_y - line.t;
      if (std::abs(t) < params_.radius / kFaceShare) continue;
      const Vec& v = t < 0 ? low : up;
      const double r = p.z - v[0] - v[1] * p.x - v[2] * p.y;
      squares += r * r, n += 1;
    }
    return std::sqrt(squares / n);
  }

  std::span<const GroundPoint> points_;
  const StepFitParams& params_;
  std::vector<double> residuals_;
};

}  // namespace

std::optional<StepFit> fit_step(std::span<const GroundPoint> points, const StepFitParams& params) {
  return StepFinder(points, params).find();
}

}  // namespace ilot
