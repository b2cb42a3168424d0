// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/facade/wild_pulses.h"

#include <cmath>

namespace ilot::scan {
namespace {

constexpr double kPulseRate = 100000, kStationSeconds = 3600;

}  // namespace

WildPulses::WildPulses(const StationParams& station)
    : station_(station),
      grid_(StationGrid(station)),
      id_(station.id),
      lines_(grid_->columns()),
      pulses_(grid_->rows()) {}

WildPulses::WildPulses(const WildDrive& drive, int head) : drive_(drive), id_(static_cast<std::uint16_t>(head)) {
  const auto steps = static_cast<std::int64_t>((180 - drive.blind_deg / 2) / drive.step_deg);
  for (std::int64_t step = -steps; step <= steps; ++step)
    angles_.push_back(sin_cos_deg(static_cast<double>(step) * drive.step_deg));
  lines_ = static_cast<std::uint64_t>(std::floor(drive.length * drive.profiles));
  pulses_ = angles_.size();
}

WildPulse WildPulses::of_station(const SinCos& azimuth, std::uint64_t line, std::uint64_t pulse) const {
  const double second = kStationSeconds * id_ + static_cast<double>(line * pulses_ + pulse) / kPulseRate;
  return {station_.position, grid_->aim(azimuth, pulse), grid_->key(line, pulse), second};
}

WildPulse WildPulses::of_head(std::uint64_t line, std::uint64_t pulse) const {
  const SinCos turned = sin_cos_deg(id_ == 1 ? drive_.turned_deg : -drive_.turned_deg), angle = angles_[pulse];
  // The vehicle leans with the road: its axes are perpendicular to each other on a slope too.
  const Vec3 level{-drive_.way.y, drive_.way.x, 0};
  const Vec3 left = (1 / norm(level)) * level, up = cross(drive_.way, left);
  const Vec3 across = turned.sin * drive_.way + turned.cos * left, along = turned.cos * drive_.way - turned.sin * left;
  // The second head is half a turn behind.
  const double turns =
      static_cast<double>(line) + static_cast<double>(pulse) / static_cast<double>(pulses_) + (id_ == 1 ? 0 : 0.5);
  const double s = turns / drive_.profiles;
  WildPulse p;
  p.origin = drive_.start + s * drive_.way;
  p.aim = {angle.sin * across + angle.cos * up, along, angle.cos * across - angle.sin * up};
  p.key = (line << 24) ^ pulse;
  p.second = s / drive_.speed;
  return p;
}

}  // namespace ilot::scan
