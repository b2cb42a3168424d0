// SPDX-License-Identifier: Apache-2.0
// The origins and directions of the pulses of an airborne scanner. Parallel flight lines along y are flown in
// alternating directions. Each swath overlaps its neighbours by half, so every position is seen from two sides.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/districts/district.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

struct AirborneParams {
  double density = 12;    // pulses per square metre, all lines together
  double height = 500;    // metres above the ground
  double angle_deg = 20;  // largest scan angle to either side, at most 45
  double jitter = 0.2;    // largest shift of a pulse's aim, as a share of the spacing
};

// Tangent of the angle by which the beam leans forward along the flight, so that walls across it are seen too.
constexpr double kForwardTangent = 0.05;

struct Pulse {
  Ray ray;              // from the sensor
  Rng rng{0};           // the pulse's own random numbers, for noise
  double gps_time = 0;  // seconds
  double scan_angle_deg = 0;
  std::uint16_t line = 0;  // number of the flight line, from 1
};

class FlightPlan {
 public:
  FlightPlan(const AirborneParams& params, const Ground& ground, std::uint64_t seed);

  // Calls visit for each pulse that is aimed at a position on the ground within the rectangle, by row, line and column.
  // If rectangles tile the plane, every pulse belongs to exactly one of them. The pulse is the same for every tiling.
  void for_each_pulse(const Rect& area, const std::function<void(const Pulse&)>& visit) const;

  double density() const { return params_.density; }

 private:
  Pulse make_pulse(std::int64_t line, std::int64_t row, std::int64_t column, double x, double y) const;

  AirborneParams params_;
  Ground ground_;
  std::uint64_t seed_;
  double half_swath_ = 0, across_ = 0, along_ = 0;
  std::int64_t half_columns_ = 0;
  std::vector<double> angles_;  // degrees to the right of straight down, per column
};

}  // namespace ilot::scan
