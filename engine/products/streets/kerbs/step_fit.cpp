// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/kerbs/step_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernels/core/portable_math.h"
#include "kernels/geometry/flat.h"
#include "kernels/planes/step_gains.h"

namespace ilot {
namespace {

constexpr std::size_t kDirections = kStepDirections;   // over half a turn
constexpr std::array<double, 4> kTurns{-6, -3, 3, 6};  // degrees, from the best of them
// Derived: points of the face of a kerb are this near to the edge (the width of two strips), where they would tilt
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

// The inverse of the matrix of a plane's normal equations; none where the points are on a line.
std::optional<PlaneInverse> inverse_of(const PlaneSums& s) {
  const double p = s.xx * s.yy - s.xy * s.xy, q = s.xy * s.y - s.x * s.yy, r = s.x * s.xy - s.xx * s.y;
  const double det = s.n * p + s.x * q + s.y * r;
  // Derived: points on a line make the determinant vanish; the bound is a width of a thousandth of the length.
  if (!(det > 1e-6 * s.n * (s.xx + s.yy) * (s.xx + s.yy))) return std::nullopt;
  return PlaneInverse{p / det,
                      q / det,
                      r / det,
                      (s.n * s.yy - s.y * s.y) / det,
                      (s.x * s.y - s.n * s.xy) / det,
                      (s.n * s.xx - s.x * s.x) / det};
}

Vec times(const PlaneInverse& m, double u, double v, double w) {
  return {m.a * u + m.b * v + m.c * w, m.b * u + m.d * v + m.e * w, m.c * u + m.e * v + m.f * w};
}

struct Line {
  double up_x = 1, up_y = 0, t = 0;
  double gain = 0;
};

// The directions that are tried, each with those near it.
struct TriedDirections {
  std::array<StepDirection, kDirections> all;
  std::array<std::array<StepDirection, kTurns.size()>, kDirections> near;

  TriedDirections() {
    const auto towards = [](double degrees) { return StepDirection{cos_degrees(degrees), cos_degrees(degrees - 90)}; };
    for (std::size_t k = 0; k < kDirections; ++k) {
      const double degrees = 180.0 * static_cast<double>(k) / kDirections;
      all[k] = towards(degrees);
      for (std::size_t t = 0; t < kTurns.size(); ++t) near[k][t] = towards(degrees + kTurns[t]);
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
    const std::optional<PlaneInverse> inverse = inverse_of(all);
    if (!inverse) return std::nullopt;
    const Vec plane = times(*inverse, all.z, all.xz, all.yz);
    columns_.resize(3 * points_.size());
    const auto column = [&](std::size_t k) { return std::span(columns_).subspan(k * points_.size(), points_.size()); };
    const std::span<double> x = column(0), y = column(1), residuals = column(2);
    double squares = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      x[i] = points_[i].x, y[i] = points_[i].y;
      residuals[i] = points_[i].z - plane[0] - plane[1] * points_[i].x - plane[2] * points_[i].y;
      squares += residuals[i] * residuals[i];
    }
    // Derived: points on both sides of a step of `lowest` have half of it as their least deviation from one plane, of
    // which a tilt takes away three quarters of the squares at most.
    if (squares < 0.0625 * params_.lowest * params_.lowest * static_cast<double>(points_.size())) return std::nullopt;
    static const TriedDirections tried;
    const StepWindow window{x, y, residuals, params_.radius, *inverse, kLeastOfSide};
    Line best;
    const std::size_t nearest = try_directions(window, tried.all, best).value_or(0);
    try_directions(window, tried.near[nearest], best);
    if (best.gain == 0) return std::nullopt;
    return of_line(best);
  }

 private:
  // Returns the last of these directions across which a line is better than the best one.
  std::optional<std::size_t> try_directions(const StepWindow& window, std::span<const StepDirection> directions,
                                            Line& best) const {
    StepGains gains;
    step_gains(window, directions, gains);
    const double per = kStepStrips / (2 * params_.radius);
    std::optional<std::size_t> better;
    for (std::size_t k = 0; k < directions.size(); ++k)
      for (std::size_t b = kStepStrips - 1; b > 0; --b) {
        const std::size_t i = k * kStepStrips + b;
        if (gains.gain[i] <= best.gain * (1 + 1e-9)) continue;
        const double sign = gains.residual[i] > 0 ? 1 : -1, t = static_cast<double>(b) / per - params_.radius;
        best = {sign * directions[k].x, sign * directions[k].y, sign * t, gains.gain[i]};
        better = k;
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
    const std::optional<PlaneInverse> low_inverse = inverse_of(low), up_inverse = inverse_of(up);
    if (!low_inverse || !up_inverse) return std::nullopt;
    const Vec a = times(*low_inverse, low.z, low.xz, low.yz), b = times(*up_inverse, up.z, up.xz, up.yz);
    if (norm(FlatPoint{a[1], a[2]}) > kSteepest || norm(FlatPoint{b[1], b[2]}) > kSteepest ||
        norm(FlatPoint{a[1] - b[1], a[2] - b[2]}) > kMostBend)
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
  std::vector<double> columns_;  // x, y and residuals of the points
};

}  // namespace

std::optional<StepFit> fit_step(std::span<const GroundPoint> points, const StepFitParams& params) {
  return StepFinder(points, params).find();
}

}  // namespace ilot
