// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/airborne.h"

#include <algorithm>
#include <cmath>

#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

constexpr double kSpeed = 60;  // metres per second over the ground
// GPS week time: line 0 passes y = 0 at kFirstSecond. Each line starts kLineSeconds after the previous one.
constexpr double kFirstSecond = 50000, kLineSeconds = 1000;
constexpr std::int64_t kLinesPerWeek = 500;

std::int64_t floor_of(double v) {
  return static_cast<std::int64_t>(std::floor(v));
}

}  // namespace

FlightPlan::FlightPlan(const AirborneParams& params, const Ground& ground, std::uint64_t seed)
    : params_(params), ground_(ground), seed_(seed) {
  half_swath_ = params.height * tan_deg(params.angle_deg);
  const double line_density = params.density / 2;
  half_columns_ = std::max<std::int64_t>(1, floor_of(half_swath_ * std::sqrt(line_density) + 0.5));
  across_ = half_swath_ / static_cast<double>(half_columns_);
  along_ = 1 / (line_density * across_);
  for (std::int64_t column = -half_columns_; column < half_columns_; ++column)
    angles_.push_back(atan_deg((static_cast<double>(column) + 0.5) * across_ / params.height));
}

Pulse FlightPlan::make_pulse(std::int64_t line, std::int64_t row, std::int64_t column, double x, double y) const {
  Pulse pulse;
  const std::uint64_t in_line =
      (static_cast<std::uint64_t>(row) << 24) ^ static_cast<std::uint64_t>(column + (1 << 23));
  pulse.rng = Rng(mix64(seed_ ^ 0x70756c7365ull) + static_cast<std::uint64_t>(line), in_line);
  const double flight = line % 2 == 0 ? 1 : -1;  // direction along y
  const double line_x = static_cast<double>(line) * half_swath_;
  const double sensor_y = y - flight * kForwardTangent * params_.height;
  const double aim_x = x + params_.jitter * across_ * (2 * pulse.rng.uniform() - 1);
  const double aim_y = y + params_.jitter * along_ * (2 * pulse.rng.uniform() - 1);
  pulse.ray.origin = {line_x, sensor_y, ground_.height(line_x, sensor_y) + params_.height};
  const Vec3 way = Vec3{aim_x, aim_y, ground_.height(aim_x, aim_y)} - pulse.ray.origin;
  pulse.ray.direction = (1 / norm(way)) * way;
  pulse.gps_time = kFirstSecond +
                   kLineSeconds * static_cast<double>((line % kLinesPerWeek + kLinesPerWeek) % kLinesPerWeek) +
                   flight * y / kSpeed;
  pulse.scan_angle_deg = flight * angles_[static_cast<std::size_t>(column + half_columns_)];
  pulse.line = static_cast<std::uint16_t>(1 + static_cast<std::uint64_t>(line) % 65535);
  return pulse;
}

void FlightPlan::for_each_pulse(const Rect& area, const std::function<void(const Pulse&)>& visit) const {
  // Within a row the aircraft moves forward by one row spacing: column c aims (c + 1/2) / columns of the spacing
  // farther.
  const double columns = 2 * static_cast<double>(half_columns_);
  const std::int64_t first_line = floor_of(area.x0 / half_swath_) - 1, last_line = floor_of(area.x1 / half_swath_) + 2;
  const std::int64_t first_row = floor_of(area.y0 / along_) - 2, last_row = floor_of(area.y1 / along_) + 2;
  for (std::int64_t row = first_row; row <= last_row; ++row) {
    for (std::int64_t line = first_line; line <= last_line; ++line) {
      const double line_x = static_cast<double>(line) * half_swath_;
      const std::int64_t first = std::max(-half_columns_, floor_of((area.x0 - line_x) / across_) - 1);
      const std::int64_t end = std::min(half_columns_, floor_of((area.x1 - line_x) / across_) + 2);
      for (std::int64_t column = first; column < end; ++column) {
        const double middle = static_cast<double>(column) + 0.5;
        const double x = line_x + middle * across_;
        const double y = (static_cast<double>(row) + middle / columns) * along_;
        if (x < area.x0 || x >= area.x1 || y < area.y0 || y >= area.y1) continue;
        visit(make_pulse(line, row, column, x, y));
      }
    }
  }
}

}  // namespace ilot::scan
