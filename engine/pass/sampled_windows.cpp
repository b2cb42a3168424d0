// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/sampled_windows.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "kernels/core/quantile.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr double kPointsPerCell = 16;
constexpr std::size_t kWindows = 32;  // where the sampling step is measured
constexpr double kPointsPerWindow = 2000;
constexpr std::size_t kMostPerWindow = 8192;

// Adds the squared distance from each point to its nearest other place, by sweeping along x.
void add_steps(std::vector<Vec3>& points, std::vector<double>& steps) {
  std::sort(points.begin(), points.end(),
            [](Vec3 a, Vec3 b) { return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z); });
  const auto same = [](Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (points.size() < 2) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double best = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t j) {
      const Vec3 d = points[j] - points[i];
      best = std::min(best, dot(d, d));
      return d.x * d.x < best;
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

MeasureGrid density_cells(Vec3 min, Vec3 max, double points) {
  const double most = static_cast<double>(kCellsPerSide) * static_cast<double>(kCellsPerSide);
  return {min, max, std::min(std::max(1.0, points / kPointsPerCell), most), static_cast<double>(kCellsPerSide)};
}

MeasureGrid step_windows(Vec3 min, Vec3 max, double points) {
  return {min, max, std::max(1.0, points / kPointsPerWindow), 0x1p20};
}

std::vector<Vec3>* SampledWindows::points_of(std::uint64_t key) {
  const auto found = points_.find(key);
  if (found != points_.end()) return &found->second;
  if (points_.size() == kWindows && key > points_.rbegin()->first) return nullptr;
  std::vector<Vec3>* list = &points_[key];
  if (points_.size() > kWindows) points_.erase(std::prev(points_.end()));
  return list;
}

void SampledWindows::add(std::size_t window, Vec3 p) {
  std::vector<Vec3>* list = points_of(mix64(window));
  if (list != nullptr && list->size() < kMostPerWindow) list->push_back(p);
}

void SampledWindows::add(const SampledWindows& next) {
  for (const auto& [key, points] : next.points_) {
    std::vector<Vec3>* list = points_of(key);
    if (list == nullptr) continue;
    const std::size_t room = kMostPerWindow - std::min(kMostPerWindow, list->size());
    list->insert(list->end(), points.begin(),
                 points.begin() + static_cast<std::ptrdiff_t>(std::min(room, points.size())));
  }
}

double SampledWindows::median_step() {
  std::vector<double> steps;
  for (auto& [key, points] : points_) add_steps(points, steps);
  return steps.empty() ? 0 : std::sqrt(upper_median(steps));
}

}  // namespace ilot
