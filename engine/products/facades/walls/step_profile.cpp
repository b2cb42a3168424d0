// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/step_profile.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

// Choice: some points in each column of a cell; the place of a step is known to half of it.
constexpr double kPointsOfCell = 2, kLeastCell = 0.01, kMostCell = 0.25;  // points; metres
// Choice: a storey has three rows, so that a plinth or a shop front alone makes no step.
constexpr double kRow = 1;  // metres
// Derived: a bound of memory.
constexpr double kMostCells = 1 << 20;
// Choice: a pier is as wide; walls bow by less than a millimetre from a straight line over it.
constexpr double kWindow = 1.5;  // metres on both sides of a step that are compared
// Derived: three standard deviations.
constexpr double kSure = 3;
// Choice: cells of a stone or a patch of plaster are wrong together.
constexpr double kTogether = 4;  // cells that count as one measurement
// Derived: a majority of three quarters.
constexpr double kRowShare = 0.75;  // share of the rows that have the step

// Sums of the normal equations of w = at + along * du + up * dv.
struct PlaneSums {
  double n = 0, u = 0, v = 0, w = 0, uu = 0, uv = 0, vv = 0, uw = 0, vw = 0, ww = 0;
  void add(double du, double dv, double dw, double weight) {
    n += weight, u += weight * du, v += weight * dv, w += weight * dw;
    uu += weight * du * du, uv += weight * du * dv, vv += weight * dv * dv;
    uw += weight * du * dw, vw += weight * dv * dw, ww += weight * dw * dw;
  }
};

}  // namespace

StepProfile::Sizes StepProfile::sizes(double width, double height, std::uint64_t points) {
  Sizes s;
  s.rows = static_cast<std::int64_t>(std::max(height, 0.0) / kRow) + 1;
  const double per_metre = static_cast<double>(points) / std::max(width, 0.01) / static_cast<double>(s.rows);
  s.cell = std::clamp(kPointsOfCell / std::max(per_metre, 1e-9), kLeastCell, kMostCell);
  s.cell = std::max(s.cell, width * static_cast<double>(s.rows) / kMostCells);
  s.columns = static_cast<std::int64_t>(std::max(width, 0.0) / s.cell) + 1;
  return s;
}

std::uint64_t StepProfile::bytes(double width, double height, std::uint64_t points) {
  const Sizes s = sizes(width, height, points);
  return static_cast<std::uint64_t>(s.columns * s.rows) * sizeof(Cell) +
         static_cast<std::uint64_t>(s.columns) * sizeof(std::array<float, 4>);
}

StepProfile::StepProfile(double width, double height, std::uint64_t points) : row_(kRow) {
  const Sizes s = sizes(width, height, points);
  cell_ = s.cell, columns_ = s.columns, rows_ = s.rows;
  cells_.resize(static_cast<std::size_t>(columns_ * rows_));
  extent_.assign(static_cast<std::size_t>(columns_), {INFINITY, -INFINITY, INFINITY, -INFINITY});
}

void StepProfile::add(const FacadePoint& p) {
  const auto part = [](double at, double size, std::int64_t count) {
    return std::clamp(static_cast<std::int64_t>(std::floor(at / size)), std::int64_t{0}, count - 1);
  };
  const std::int64_t c = part(p.u, cell_, columns_);
  Cell& at = cells_[static_cast<std::size_t>(c * rows_ + part(p.v, row_, rows_))];
  const double w = p.w;
  at.count += 1, at.sum += w, at.squares += w * w;
  auto& e = extent_[static_cast<std::size_t>(c)];
  e = {std::min(e[0], p.u), std::max(e[1], p.u), std::min(e[2], p.v), std::max(e[3], p.v)};
}

Place2 StepProfile::middle(std::int64_t c, std::int64_t r) const {
  return {(static_cast<double>(c) + 0.5) * cell_, (static_cast<double>(r) + 0.5) * row_};
}

bool StepProfile::empty_column(std::int64_t c) const {
  return !(extent_[static_cast<std::size_t>(c)][0] < INFINITY);
}

// The plane of the columns [c0, c1), by least squares over cells: each counts once, however near the scanner stood.
LocalPlane StepProfile::fit(std::int64_t c0, std::int64_t c1) const {
  LocalPlane plane;
  plane.u0 = static_cast<double>(c0 + c1) / 2 * cell_, plane.v0 = static_cast<double>(rows_) / 2 * row_;
  PlaneSums s;
  for (std::int64_t c = c0; c < c1; ++c)
    for (std::int64_t r = 0; r < rows_; ++r) {
      const Cell& at = cell(c, r);
      const Place2 p = middle(c, r);
      if (at.count > 0) s.add(p.u - plane.u0, p.v - plane.v0, at.sum / at.count, 1);
    }
  plane.error = INFINITY;
  if (s.n < 2 * kTogether) return plane;
  const double uu = s.uu - s.u * s.u / s.n, vv = s.vv - s.v * s.v / s.n, uv = s.uv - s.u * s.v / s.n;
  const double uw = s.uw - s.u * s.w / s.n, vw = s.vw - s.v * s.w / s.n, ww = s.ww - s.w * s.w / s.n;
  const double det = uu * vv - uv * uv;
  if (uu > 0 && vv > 0 && det > 1e-6 * uu * vv) {
    plane.along = (uw * vv - vw * uv) / det, plane.up = (vw * uu - uw * uv) / det;
  } else if (uu > 0) {
    plane.along = uw / uu;
  }
  plane.at = (s.w - plane.along * s.u - plane.up * s.v) / s.n;
  const double left = std::max(0.0, ww - plane.along * uw - plane.up * vw) / s.n;
  // The end of a line is known half as well as its middle.
  plane.error = 2 * std::sqrt(left * kTogether / s.n);
  return plane;
}

// The step between the wall on the left and on the right of a column; 0 where it is not certain.
double StepProfile::step_at(std::int64_t c, std::int64_t from, std::int64_t to, const StepParams& params) const {
  const auto window = std::max<std::int64_t>(1, static_cast<std::int64_t>(kWindow / cell_));
  const LocalPlane a = fit(std::max(from, c - window), c), b = fit(c, std::min(to, c + window));
  const double error = kSure * std::sqrt(a.error * a.error + b.error * b.error);
  if (!(error < INFINITY)) return 0;
  const double u = static_cast<double>(c) * cell_, v = static_cast<double>(rows_) / 2 * row_;
  const double step = b.w(u, v) - a.w(u, v);
  return std::abs(step) - error >= params.least_step ? step : 0;
}

// The step between the wall a metre and more to the left of a column and a metre and more to the right of it: pilasters
// and quoins are narrower and step back again. A bow is the same on both sides.
double StepProfile::far_step(std::int64_t c, std::int64_t from, std::int64_t to, const StepParams& params) const {
  const auto beyond = std::max<std::int64_t>(1, static_cast<std::int64_t>(params.least_width / cell_));
  const LocalPlane a = fit(std::max(from, c - beyond), std::max(from + 1, c - beyond / 2));
  const LocalPlane b = fit(std::min(to - 1, c + beyond / 2), std::min(to, c + beyond));
  if (!(a.error < INFINITY) || !(b.error < INFINITY)) return 0;
  const double u = static_cast<double>(c) * cell_, v = static_cast<double>(rows_) / 2 * row_;
  return b.w(u, v) - a.w(u, v);
}

// Whether most rows in which both sides were seen have the step, over a sufficient height.
bool StepProfile::persists(std::int64_t c, std::int64_t from, std::int64_t to, double step,
                           const StepParams& params) const {
  const double farther = far_step(c, from, to, params);
  if (farther * step <= 0 || std::abs(farther) < std::abs(step) / 2) return false;
  const auto window = std::max<std::int64_t>(1, static_cast<std::int64_t>(kWindow / cell_));
  const std::int64_t c0 = std::max(from, c - window), c1 = std::min(to, c + window);
  const LocalPlane a = fit(c0, c), b = fit(c, c1);
  const double slope = (a.along + b.along) / 2, u = static_cast<double>(c) * cell_;
  double seen = 0, stepped = 0;
  for (std::int64_t r = 0; r < rows_; ++r) {
    std::array<double, 2> n{}, w{};
    for (std::int64_t k = c0; k < c1; ++k) {
      const Cell& at = cell(k, r);
      if (!(at.count > 0)) continue;
      const std::size_t side = k < c ? 0 : 1;
      n[side] += 1, w[side] += at.sum / at.count - slope * (middle(k, r).u - u);
    }
    if (n[0] < kTogether || n[1] < kTogether) continue;
    const double own = w[1] / n[1] - w[0] / n[0];
    seen += 1;
    stepped += own * step > 0 && std::abs(own) >= std::abs(step) / 2;
  }
  return seen * row_ >= params.least_height && stepped >= kRowShare * seen;
}

// The column near c at which two levels with the slopes of both sides explain the cells best.
std::int64_t StepProfile::sharpened(std::int64_t c, std::int64_t from, std::int64_t to) const {
  const auto window = std::max<std::int64_t>(1, static_cast<std::int64_t>(kWindow / cell_));
  const auto reach = static_cast<std::int64_t>(2 * kMostCell / cell_) + 1;
  const LocalPlane a = fit(std::max(from, c - window), std::max(from + 1, c - reach));
  const LocalPlane b = fit(std::min(to - 1, c + reach), std::min(to, c + window));
  if (!(a.error < INFINITY) || !(b.error < INFINITY)) return c;
  const std::int64_t low = std::max(from + 1, c - reach), high = std::min(to - 1, c + reach);
  double sum = 0, least = 0;
  std::int64_t best = low;
  for (std::int64_t k = low; k < high; ++k) {
    for (std::int64_t r = 0; r < rows_; ++r) {
      const Cell& at = cell(k, r);
      if (!(at.count > 0)) continue;
      const Place2 p = middle(k, r);
      const double w = at.sum / at.count, da = w - a.w(p.u, p.v), db = w - b.w(p.u, p.v);
      sum += at.count * (da * da - db * db);
    }
    if (sum < least) least = sum, best = k + 1;
  }
  return best;
}

// Adds the borders within the columns [from, to): the greatest step first, then those on both sides of it.
void StepProfile::split(std::int64_t from, std::int64_t to, const StepParams& params,
                        std::vector<std::int64_t>& borders) const {
  const auto least = static_cast<std::int64_t>(params.least_width / cell_) + 1;
  const auto stride = std::max<std::int64_t>(1, static_cast<std::int64_t>(0.1 / cell_));
  std::vector<Step> steps;
  for (std::int64_t c = from + least; c <= to - least; c += stride)
    if (const double step = step_at(c, from, to, params); step != 0) steps.push_back({static_cast<double>(c), step});
  std::stable_sort(steps.begin(), steps.end(), [](Step a, Step b) { return std::abs(a.size) > std::abs(b.size); });
  for (const Step& s : steps) {
    const std::int64_t c = sharpened(static_cast<std::int64_t>(s.at), from, to);
    if (c < from + least || c > to - least) continue;
    const double step = step_at(c, from, to, params);
    if (step == 0 || !persists(c, from, to, step, params)) continue;
    split(from, c, params, borders);
    borders.push_back(c);
    split(c, to, params, borders);
    return;
  }
}

WallStretch StepProfile::stretch(std::int64_t from, std::int64_t to) const {
  const auto window = std::max<std::int64_t>(1, static_cast<std::int64_t>(kWindow / cell_));
  WallStretch s;
  s.u0 = s.v0 = INFINITY, s.u1 = s.v1 = -INFINITY;
  for (std::int64_t c = from; c < to; ++c) {
    const auto& e = extent_[static_cast<std::size_t>(c)];
    s.u0 = std::min<double>(s.u0, e[0]), s.u1 = std::max<double>(s.u1, e[1]);
    s.v0 = std::min<double>(s.v0, e[2]), s.v1 = std::max<double>(s.v1, e[3]);
  }
  s.plane = fit(from, to), s.left = fit(from, std::min(to, from + window)),
  s.right = fit(std::max(from, to - window), to);
  double squares = 0, count = 0;
  for (std::int64_t c = from; c < to; ++c)
    for (std::int64_t r = 0; r < rows_; ++r) {
      const Cell& at = cell(c, r);
      const Place2 p = middle(c, r);
      const double w = s.plane.w(p.u, p.v);
      count += at.count, squares += at.squares - 2 * w * at.sum + w * w * at.count;
    }
  s.points = static_cast<std::uint64_t>(count);
  s.rms = count > 0 ? std::sqrt(std::max(0.0, squares / count)) : 0;
  return s;
}

std::vector<double> StepProfile::steps(const StepParams& params) const {
  std::vector<std::int64_t> borders;
  split(0, columns_, params, borders);
  std::vector<double> places;
  for (const std::int64_t border : borders) places.push_back(static_cast<double>(border) * cell_);
  return places;
}

double StepProfile::points_in(std::int64_t c0, std::int64_t c1, double v0, double v1) const {
  double sum = 0;
  for (std::int64_t c = c0; c < c1; ++c)
    for (std::int64_t r = static_cast<std::int64_t>(v0 / row_); r <= static_cast<std::int64_t>(v1 / row_); ++r)
      sum += cell(c, std::clamp(r, std::int64_t{0}, rows_ - 1)).count;
  return sum;
}

std::vector<WallStretch> StepProfile::stretches(const StepParams& params, std::span<const double> steps,
                                                const StepProfile& all) const {
  std::vector<WallStretch> found;
  const auto add = [&](std::int64_t from, std::int64_t to) {
    WallStretch s = stretch(from, to);
    s.share = static_cast<double>(s.points) / std::max(1.0, all.points_in(from, to, s.v0, s.v1));
    found.push_back(s);
  };
  const auto gap = static_cast<std::int64_t>(params.gap / cell_) + 1;
  std::int64_t first = -1, last = -1;
  auto next = steps.begin();
  for (std::int64_t c = 0; c < columns_; ++c) {
    bool ends = false;
    for (; next != steps.end() && std::llround(*next / cell_) <= c; ++next) ends = true;
    if (first >= 0 && (ends || c - last > gap)) add(first, last + 1), first = -1;
    if (empty_column(c)) continue;
    if (first < 0) first = c;
    last = c;
  }
  if (first >= 0) add(first, last + 1);
  for (WallStretch& s : found)
    for (const double step : steps) {
      s.left_step = s.left_step || std::abs(step - s.u0) <= kMostCell;
      s.right_step = s.right_step || std::abs(step - s.u1) <= kMostCell;
    }
  return found;
}

}  // namespace ilot
