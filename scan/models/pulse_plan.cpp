// SPDX-License-Identifier: Apache-2.0
#include "scan/models/pulse_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

constexpr std::uint64_t kGrainPulses = 1 << 15;
constexpr double kPulseRate = 100000, kStationSeconds = 3600, kFirstSecond = 200000;
constexpr double kTile = 10;  // metres, of a flight

Vec3 unit(Vec3 v) {
  return (1 / norm(v)) * v;
}

// Two directions across a beam.
Aim aim_along(Vec3 axis) {
  const Vec3 helper = std::abs(axis.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 right = unit(cross(axis, helper));
  return {axis, right, cross(right, axis)};
}

class StationPulses : public PulsePlan {
 public:
  StationPulses(const StationParams& station, std::uint64_t seed)
      : station_(station), grid_(station), seed_(mix64(seed ^ 0x746c73ull) + station.id) {
    width_ = std::max<std::uint64_t>(1, kGrainPulses / std::max<std::uint64_t>(1, grid_.rows()));
  }

  std::uint64_t grains() const override { return (grid_.columns() + width_ - 1) / width_; }

  void for_each(std::uint64_t grain, const std::function<void(PlannedPulse&)>& visit) const override {
    const std::uint64_t end = std::min(grid_.columns(), (grain + 1) * width_);
    for (std::uint64_t column = grain * width_; column < end; ++column) {
      const SinCos azimuth = grid_.azimuth(column);
      for (std::uint64_t row = 0; row < grid_.rows(); ++row) {
        PlannedPulse pulse{station_.position, grid_.aim(azimuth, row), Rng(seed_, grid_.key(column, row)), 0, 0,
                           station_.id};
        pulse.time = kFirstSecond + kStationSeconds * station_.id +
                     static_cast<double>(column * grid_.rows() + row) / kPulseRate;
        visit(pulse);
      }
    }
  }

 private:
  StationParams station_;
  StationGrid grid_;
  std::uint64_t seed_, width_ = 1;
};

class VehiclePulses : public PulsePlan {
 public:
  VehiclePulses(const VehicleParams& vehicle, std::uint64_t seed) : v_(vehicle), seed_(seed ^ 0x6d6f62696c65ull) {
    const auto steps = static_cast<std::int64_t>((180 - v_.blind_deg / 2) / v_.step_deg);
    for (std::int64_t step = -steps; step <= steps; ++step) {
      angles_.push_back(static_cast<double>(step) * v_.step_deg);
      turns_.push_back(sin_cos_deg(angles_.back()));
    }
    turns_count_ = static_cast<std::uint64_t>(std::floor(path_length(v_.path) * v_.profiles));
    per_grain_ = std::max<std::uint64_t>(1, kGrainPulses / (2 * angles_.size()));
    ends_.push_back(0);
    for (std::size_t i = 1; i < v_.path.size(); ++i) ends_.push_back(ends_.back() + norm(v_.path[i] - v_.path[i - 1]));
  }

  std::uint64_t grains() const override { return (turns_count_ + per_grain_ - 1) / per_grain_; }

  void for_each(std::uint64_t grain, const std::function<void(PlannedPulse&)>& visit) const override {
    const std::uint64_t end = std::min(turns_count_, (grain + 1) * per_grain_);
    for (std::uint64_t turn = grain * per_grain_; turn < end; ++turn)
      for (const int head : {1, 2}) scan_turn(turn, head, visit);
  }

 private:
  void scan_turn(std::uint64_t turn, int head, const std::function<void(PlannedPulse&)>& visit) const {
    const SinCos turned = sin_cos_deg(head == 1 ? v_.turned_deg : -v_.turned_deg);
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      // The second head is half a turn behind.
      const double turns = static_cast<double>(turn) + angles_[i] / 360 + 0.5 + (head == 1 ? 0 : 0.5);
      const double s = std::min(turns / v_.profiles, ends_.back());
      const auto after = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, s) - ends_.begin();
      const auto at = static_cast<std::size_t>(after);
      const Vec3 a = v_.path[at - 1], b = v_.path[at];
      const double length = ends_[at] - ends_[at - 1];
      const Vec3 along = (1 / length) * (b - a);
      const Vec3 ahead = unit({along.x, along.y, 0}), left{-ahead.y, ahead.x, 0};
      const Vec3 across = turned.cos * left + turned.sin * ahead;
      const Vec3 axis = turns_[i].sin * across + turns_[i].cos * Vec3{0, 0, 1};
      const std::uint64_t key = (turn << 24) ^ (static_cast<std::uint64_t>(head - 1) << 23) ^ i;
      PlannedPulse pulse{a + (s - ends_[at - 1]) * along,
                         aim_along(unit(axis)),
                         Rng(seed_, key),
                         0,
                         angles_[i],
                         static_cast<std::uint16_t>(v_.source + head - 1)};
      pulse.time = kFirstSecond / 2 + turns / (v_.profiles * v_.speed);
      visit(pulse);
    }
  }

  VehicleParams v_;
  std::uint64_t seed_, turns_count_ = 0, per_grain_ = 1;
  std::vector<double> angles_, ends_;
  std::vector<SinCos> turns_;
};

class FlightPulses : public PulsePlan {
 public:
  FlightPulses(const FlightParams& flight, std::uint64_t seed)
      : f_(flight), plan_(flight.airborne, Ground{flight.ground_z, 0, 0}, seed) {
    // FlightPlan numbers its lines from the origin of x; moved by whole swaths, all numbers are positive.
    const double swath = f_.airborne.height * tan_deg(f_.airborne.angle_deg);
    moved_ = swath * (2 + std::max(0.0, std::ceil(-f_.area.x0 / swath)));
    f_.area.x0 += moved_;
    f_.area.x1 += moved_;
    nx_ = tiles(f_.area.x0, f_.area.x1);
    ny_ = tiles(f_.area.y0, f_.area.y1);
  }

  std::uint64_t grains() const override { return nx_ * ny_; }

  void for_each(std::uint64_t grain, const std::function<void(PlannedPulse&)>& visit) const override {
    const double x = f_.area.x0 + kTile * static_cast<double>(grain % nx_);
    const double y = f_.area.y0 + kTile * static_cast<double>(grain / nx_);
    const Rect tile{x, y, std::min(x + kTile, f_.area.x1), std::min(y + kTile, f_.area.y1)};
    plan_.for_each_pulse(tile, [&](const Pulse& pulse) {
      PlannedPulse planned{pulse.ray.origin - Vec3{moved_, 0, 0},
                           aim_along(pulse.ray.direction),
                           pulse.rng,
                           pulse.gps_time,
                           pulse.scan_angle_deg,
                           static_cast<std::uint16_t>(f_.source + pulse.line - 2)};
      visit(planned);
    });
  }

 private:
  static std::uint64_t tiles(double a, double b) {
    return static_cast<std::uint64_t>(std::max(1.0, std::ceil((b - a) / kTile)));
  }

  FlightParams f_;
  FlightPlan plan_;
  double moved_ = 0;  // metres along x
  std::uint64_t nx_ = 1, ny_ = 1;
};

}  // namespace

double path_length(const std::vector<Vec3>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += norm(path[i] - path[i - 1]);
  return length;
}

std::unique_ptr<PulsePlan> plan_pulses(const StationParams& station, std::uint64_t seed) {
  return std::make_unique<StationPulses>(station, seed);
}

std::unique_ptr<PulsePlan> plan_pulses(const VehicleParams& vehicle, std::uint64_t seed) {
  return std::make_unique<VehiclePulses>(vehicle, seed);
}

std::unique_ptr<PulsePlan> plan_pulses(const FlightParams& flight, std::uint64_t seed) {
  return std::make_unique<FlightPulses>(flight, seed);
}

}  // namespace ilot::scan
