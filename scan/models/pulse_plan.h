// SPDX-License-Identifier: Apache-2.0
// The pulses of any scanner in one form: a tripod, two heads on a vehicle that follows a path, or an aircraft over
// parallel lines. Pulses come in grains of bounded size, which threads share out.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/scanners/airborne.h"
#include "scan/scanners/beam.h"
#include "scan/scanners/station.h"

namespace ilot::scan {

struct PlannedPulse {
  Vec3 origin;
  Aim aim;
  Rng rng{0};       // of this pulse alone
  double time = 0;  // GPS seconds
  double angle_deg = 0;
  std::uint16_t source = 0;  // point_source_id
};

// What all pulses of a scanner have in common.
struct ScannerBeam {
  BeamParams beam;
  double full_range = 8;  // metres: at this range a white, perpendicular surface fills the scale of intensities
  Vec3 shift;             // registration error: all points of the scan are moved by it
};

class PulsePlan {
 public:
  virtual ~PulsePlan() = default;
  virtual std::uint64_t grains() const = 0;
  virtual void for_each(std::uint64_t grain, const std::function<void(PlannedPulse&)>& visit) const = 0;
};

// The path of a vehicle: corners in metres of the scene, at the height of the heads.
struct VehicleParams {
  std::vector<Vec3> path;
  double profiles = 40;      // turns of each head per metre
  double step_deg = 0.25;    // between pulses of a turn
  double turned_deg = 40;    // of the planes from straight across, one head to each side
  double blind_deg = 20;     // of a turn, downwards, where the vehicle hides the ground
  double speed = 8;          // metres per second
  std::uint16_t source = 1;  // of the first head; the second has the next number
};

struct FlightParams {
  AirborneParams airborne;
  Rect area;                 // on the ground, where pulses aim
  double ground_z = 0;       // metres
  std::uint16_t source = 1;  // of the first line
};

// The plans keep copies of what they are given. The same parameters give the same pulses.
std::unique_ptr<PulsePlan> plan_pulses(const StationParams& station, std::uint64_t seed);
std::unique_ptr<PulsePlan> plan_pulses(const VehicleParams& vehicle, std::uint64_t seed);
std::unique_ptr<PulsePlan> plan_pulses(const FlightParams& flight, std::uint64_t seed);

double path_length(const std::vector<Vec3>& path);

}  // namespace ilot::scan
