// SPDX-License-Identifier: Apache-2.0
// A scanner on a vehicle that drives along a street. It has two heads that spin in upright planes. The planes are
// turned to either side of the direction of travel, so one head sees what is hidden from the other.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/optics/part_scene.h"
#include "scan/optics/ray_scene.h"

namespace ilot::scan {

struct MobileParams {
  double from = 0, to = 100;  // metres along the street
  double lane = -1.6;         // lane of the vehicle, from the street's axis
  double height = 2.6;        // height of the heads above the road
  double profiles = 10;       // turns per metre and head
  double step_deg = 0.4;      // between pulses of a turn
  double turned_deg = 40;     // turn of the planes from straight across the street
  double blind_deg = 20;      // part of a turn, downwards, where the vehicle hides the street
  double noise = 0.008;       // metres, standard deviation of the range
  double range = 50;          // metres, the farthest echo
  double speed = 8;           // metres per second
  std::uint64_t seed = 0;
};

// One echo, in street coordinates.
struct MobileEcho {
  Vec3 place;          // with noise
  Vec3 surface_place;  // without
  double cosine = 1, range = 0;
  SurfaceLabel label;
  std::uint8_t head = 1;
  double angle_deg = 0;  // of the turn, 0 = up
  double time = 0;       // seconds from the start
};

// What the heads see: parts, crowns, and the label of the leaves of a crown.
struct MobileScene {
  const SceneModel& model;
  const PartScene& parts;
  const RayScene& crowns;
  SurfaceLabel leaves;
  double base = 0, slope = 0;  // z of the road = base + slope s
};

// Returns the number of turns of one head. Both heads have the same number.
std::uint64_t profile_count(const MobileParams& params);

// Returns the position of a head at a position s of the drive, and the direction of a pulse of head 1 or 2 at an angle
// from the upright.
Vec3 head_position(const MobileParams& params, const MobileScene& scene, double s);
Vec3 pulse_direction(const MobileParams& params, int head, double angle_deg);

// Follows the pulses, turn after turn. It keeps its own memory, so each thread needs one.
class MobileScanner {
 public:
  MobileScanner(const MobileParams& params, const MobileScene& scene);

  std::uint64_t pulses_per_turn() const { return angles_.size(); }

  // Visits the echoes of one turn of one head (1 or 2), in the order of its pulses. The result is the same for every
  // scanner.
  void scan(std::uint64_t profile, int head, const std::function<void(const MobileEcho&)>& visit);

 private:
  struct Found {
    double range = 0, cosine = 1;
    SurfaceLabel label;
  };
  std::optional<Found> look(const Ray& ray, Rng& rng);

  const MobileParams& params_;
  const MobileScene& scene_;
  std::vector<double> angles_;
  std::array<std::vector<Vec3>, 2> directions_;  // for each head, of each angle
  std::vector<Candidate> candidates_;
  CastResult crowns_;
};

}  // namespace ilot::scan
