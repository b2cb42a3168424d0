// SPDX-License-Identifier: Apache-2.0
// Where the pulses of a wild scan start and where they point: tripods, or a vehicle with two turning heads.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "scan/scanners/station.h"

namespace ilot::scan {

// A vehicle that drives along a straight line. Each head turns in a plane that is perpendicular to the road and turned
// from straight across by the same angle to either side.
struct WildDrive {
  Vec3 start;            // of the heads
  Vec3 way{1, 0, 0};     // unit length; not upright
  double length = 50;    // metres
  double profiles = 30;  // turns of each head per metre
  double step_deg = 0.3;
  double turned_deg = 40, blind_deg = 60, speed = 8;
};

struct WildPulse {
  Vec3 origin;
  Aim aim;
  std::uint64_t key = 0;  // of its random numbers; depends on its angles only
  double second = 0;
};

// The pulses of one station, or of one head of the vehicle, in lines of equal length.
class WildPulses {
 public:
  explicit WildPulses(const StationParams& station);
  WildPulses(const WildDrive& drive, int head);  // 1 or 2

  std::uint16_t id() const { return id_; }
  std::uint64_t lines() const { return lines_; }
  std::uint64_t pulses() const { return pulses_; }  // of a line
  const StationParams& station() const { return station_; }

  // Visits the pulses of a line in order.
  template <class Visit>
  void each(std::uint64_t line, const Visit& visit) const {
    const SinCos azimuth = grid_ ? grid_->azimuth(line) : SinCos{};
    for (std::uint64_t i = 0; i < pulses_; ++i) visit(grid_ ? of_station(azimuth, line, i) : of_head(line, i));
  }

 private:
  WildPulse of_station(const SinCos& azimuth, std::uint64_t line, std::uint64_t pulse) const;
  WildPulse of_head(std::uint64_t line, std::uint64_t pulse) const;

  StationParams station_;
  std::optional<StationGrid> grid_;
  WildDrive drive_;
  std::vector<SinCos> angles_;
  std::uint16_t id_ = 1;
  std::uint64_t lines_ = 0, pulses_ = 0;
};

}  // namespace ilot::scan
