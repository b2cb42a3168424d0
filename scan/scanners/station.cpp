// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/station.h"

#include <algorithm>
#include <cmath>

namespace ilot::scan {
namespace {

constexpr double kMaxElevation = 88;  // degrees; of a window

// Returns the angle in degrees of a position that is `across` to the side and `ahead` in front, within [-180, 180].
double angle_deg(double across, double ahead) {
  if (std::abs(across) > std::abs(ahead)) return (across < 0 ? -90 : 90) - atan_deg(ahead / across);
  if (ahead == 0) return 0;
  const double angle = atan_deg(across / ahead);
  return ahead > 0 ? angle : across < 0 ? angle - 180 : angle + 180;
}

std::int64_t floor_of(double v) {
  return static_cast<std::int64_t>(std::floor(v));
}

}  // namespace

StationParams station_towards(std::uint16_t id, Vec3 position, const Box3<Vec3>& target, double step_deg) {
  StationParams station{id, position, {0, 1, 0}, step_deg, step_deg, {}};
  const Vec3 middle = 0.5 * (target.min + target.max) - position;
  const Vec3 flat{middle.x, middle.y, 0};
  if (norm(flat) > 0) station.forward = (1 / norm(flat)) * flat;
  const Vec3 right{station.forward.y, -station.forward.x, 0};
  AngleWindow& w = station.window;
  w = {180, -180, 0, 0};
  for (double x : {target.min.x, target.max.x})
    for (double y : {target.min.y, target.max.y}) {
      const Vec3 corner = Vec3{x, y, position.z} - position;
      const double azimuth = angle_deg(dot(corner, right), dot(corner, station.forward));
      w.left = std::min(w.left, azimuth);
      w.right = std::max(w.right, azimuth);
    }
  const double dx = std::max({target.min.x - position.x, position.x - target.max.x, 0.0});
  const double dy = std::max({target.min.y - position.y, position.y - target.max.y, 0.0});
  const double nearest = std::sqrt(dx * dx + dy * dy);
  const double far_x = std::max(std::abs(target.min.x - position.x), std::abs(target.max.x - position.x));
  const double far_y = std::max(std::abs(target.min.y - position.y), std::abs(target.max.y - position.y));
  const double furthest = std::sqrt(far_x * far_x + far_y * far_y);
  const double low = target.min.z - position.z, high = target.max.z - position.z;
  w.low = std::max(-kMaxElevation, angle_deg(low, low < 0 ? nearest : furthest));
  w.high = std::min(kMaxElevation, angle_deg(high, high > 0 ? nearest : furthest));
  return station;
}

StationGrid::StationGrid(const StationParams& params)
    : params_(params), right_{params.forward.y, -params.forward.x, 0} {
  first_column_ = floor_of(params.window.left / params.step_horizontal_deg);
  columns_ = static_cast<std::uint64_t>(
      std::max<std::int64_t>(0, floor_of(params.window.right / params.step_horizontal_deg) + 2 - first_column_));
  first_row_ = floor_of(params.window.low / params.step_vertical_deg);
  const std::int64_t end_row = floor_of(params.window.high / params.step_vertical_deg) + 2;
  for (std::int64_t row = first_row_; row < end_row; ++row)
    rows_.push_back(sin_cos_deg(static_cast<double>(row) * params.step_vertical_deg));
}

SinCos StationGrid::azimuth(std::uint64_t column) const {
  return sin_cos_deg(static_cast<double>(first_column_ + static_cast<std::int64_t>(column)) *
                     params_.step_horizontal_deg);
}

Aim StationGrid::aim(const SinCos& azimuth, std::uint64_t row) const {
  const SinCos elevation = rows_[row];
  const Vec3 ahead = azimuth.cos * params_.forward + azimuth.sin * right_;
  const Vec3 right = azimuth.cos * right_ - azimuth.sin * params_.forward;
  const Vec3 zenith{0, 0, 1};
  return {elevation.cos * ahead + elevation.sin * zenith, right, elevation.cos * zenith - elevation.sin * ahead};
}

std::uint64_t StationGrid::key(std::uint64_t column, std::uint64_t row) const {
  return (static_cast<std::uint64_t>(first_column_ + static_cast<std::int64_t>(column)) << 32) ^
         static_cast<std::uint64_t>(first_row_ + static_cast<std::int64_t>(row) + (std::int64_t{1} << 31));
}

}  // namespace ilot::scan
