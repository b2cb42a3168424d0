// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/sampled_windows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "kernels/core/quantile.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr double kPointsPerCell = 16;
constexpr std::size_t kWindows = 32;  // where the sampling step is measured
constexpr double kPointsPerWindow = 2000;
constexpr std::size_t kMostPerWindow = 8192;
constexpr std::size_t kSlices = 64;  // of a window along an axis

Vec3 scaled(Vec3 p, Vec3 by) {
  return {p.x * by.x, p.y * by.y, p.z * by.z};
}

// Keeps the kMostPerWindow points nearest to a place in plan.
void keep_nearest(std::vector<Vec3>& points, Vec3 to) {
  if (points.size() <= kMostPerWindow) return;
  const auto key = [&](Vec3 p) {
    return std::tuple((p.x - to.x) * (p.x - to.x) + (p.y - to.y) * (p.y - to.y), p.x, p.y, p.z);
  };
  std::nth_element(points.begin(), points.begin() + kMostPerWindow, points.end(),
                   [&](Vec3 a, Vec3 b) { return key(a) < key(b); });
  points.resize(kMostPerWindow);
}

// Grows with the number of points that a sweep along an axis looks at: the density along the axis about each point,
// summed over the points of slices.
double crowding(const std::vector<Vec3>& points, double Vec3::*axis) {
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [&](const Vec3& a, const Vec3& b) { return a.*axis < b.*axis; });
  const double from = (*low).*axis, slice = ((*high).*axis - from) / kSlices;
  if (!(slice > 0)) return std::numeric_limits<double>::infinity();
  std::array<double, kSlices> count{};
  for (const Vec3& p : points) ++count[std::min(kSlices - 1, static_cast<std::size_t>((p.*axis - from) / slice))];
  double sum = 0;
  for (const double n : count) sum += n * n / slice;
  return sum;
}

// The axis along which a sweep meets the fewest points: on a wall not across it, on roofs not upwards.
double Vec3::*least_crowded(const std::vector<Vec3>& points) {
  double Vec3::*best = &Vec3::x;
  double least = crowding(points, best);
  for (double Vec3::*axis : {&Vec3::y, &Vec3::z})
    if (const double here = crowding(points, axis); here < least) least = here, best = axis;
  return best;
}

// Adds the squared distance from each point to its nearest other place, by sweeping along an axis.
void add_steps(std::vector<Vec3>& points, std::vector<double>& steps) {
  if (points.empty()) return;
  double Vec3::*const along = least_crowded(points);
  std::sort(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return a.*along != b.*along ? a.*along < b.*along : std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  const auto same = [](Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (points.size() < 2) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double best = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t j) {
      const Vec3 d = points[j] - points[i];
      best = std::min(best, dot(d, d));
      return d.*along * d.*along < best;
    };
    for (std::size_t j = i; j > 0 && look(j - 1);) --j;
    for (std::size_t j = i + 1; j < points.size() && look(j);) ++j;
    steps.push_back(best);
  }
}

}  // namespace

MeasureGrid::MeasureGrid(Vec3 min, Vec3 max, double wanted, double most_per_side) : x(min.x), y(min.y) {
  const double width = max.x - min.x, height = max.y - min.y;
  const double longest = std::max(width, height);
  if (!(longest > 0) || !std::isfinite(longest)) return;
  side = std::max(std::sqrt(width * height / wanted), longest / std::min(wanted, most_per_side));
  columns = static_cast<std::size_t>(width / side) + 1;
  rows = static_cast<std::size_t>(height / side) + 1;
}

std::size_t MeasureGrid::cell(Vec3 p) const {
  const auto column = std::min(columns - 1, static_cast<std::size_t>((p.x - x) / side));
  const auto row = std::min(rows - 1, static_cast<std::size_t>((p.y - y) / side));
  return row * columns + column;
}

Vec3 MeasureGrid::middle(std::size_t cell) const {
  return {x + (static_cast<double>(cell % columns) + 0.5) * side,
          y + (static_cast<double>(cell / columns) + 0.5) * side, 0};
}

MeasureGrid density_cells(Vec3 min, Vec3 max, double points) {
  const double most = static_cast<double>(kCellsPerSide) * static_cast<double>(kCellsPerSide);
  return {min, max, std::min(std::max(1.0, points / kPointsPerCell), most), static_cast<double>(kCellsPerSide)};
}

MeasureGrid step_windows(Vec3 min, Vec3 max, double points) {
  return {min, max, std::max(1.0, points / kPointsPerWindow), 0x1p20};
}

SampledWindows::SampledWindows(const MeasureGrid& windows, Vec3 origin, Vec3 metres)
    : windows_(windows), origin_(origin), metres_(metres) {}

// The window with this key, if it is among those with the smallest keys.
SampledWindows::Window* SampledWindows::kept(std::uint64_t key) {
  const auto found = kept_.find(key);
  if (found != kept_.end()) return &found->second;
  if (kept_.size() == kWindows && key > kept_.rbegin()->first) return nullptr;
  Window* window = &kept_[key];
  if (kept_.size() > kWindows) kept_.erase(std::prev(kept_.end()));
  return window;
}

SampledWindows::Window* SampledWindows::window_of(std::size_t cell) {
  Window* window = kept(mix64(cell));
  if (window != nullptr && window->points.empty())
    window->middle = scaled(windows_.middle(cell) - Vec3{origin_.x, origin_.y, 0}, metres_);
  return window;
}

void SampledWindows::add(Vec3 p) {
  Window* window = window_of(windows_.cell(p));
  if (window == nullptr) return;
  window->points.push_back(scaled(p - origin_, metres_));
  if (window->points.size() == 2 * kMostPerWindow) keep_nearest(window->points, window->middle);
}

void SampledWindows::add(const SampledWindows& other) {
  for (const auto& [key, theirs] : other.kept_) {
    Window* window = kept(key);
    if (window == nullptr) continue;
    window->middle = theirs.middle;
    window->points.insert(window->points.end(), theirs.points.begin(), theirs.points.end());
    keep_nearest(window->points, window->middle);
  }
}

double SampledWindows::median_step() {
  std::vector<double> steps;
  for (auto& [key, window] : kept_) {
    keep_nearest(window.points, window.middle);
    add_steps(window.points, steps);
  }
  return steps.empty() ? 0 : std::sqrt(upper_median(steps));
}

}  // namespace ilot
