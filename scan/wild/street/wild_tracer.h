// SPDX-License-Identifier: Apache-2.0
// The echoes of a pulse in `street-wild`: solids that stand or move, leaves, panes, wet ground and mixed points.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scan/optics/ray_scene.h"
#include "scan/wild/street/wild_street.h"

namespace ilot::scan {

struct WildBeam {
  double noise = 0.01;           // metres, standard deviation of the range
  double divergence_mrad = 0.5;  // full angle
  double separation = 0.3;       // metres: closer echoes mix into one
  double range = 80;             // metres, the farthest echo
  double nearest = 0.8;          // metres: nearer echoes are the scanner's own
  double glass_echo = 0.2;       // share of the pulses on panes that come back from them
  double glass_through = 0.2;    // of the others, the share that goes on behind
  double wet = 0;                // share of wet asphalt, which mirrors pulses away
  double roughness = 0.01;       // metres, of grass; of other ground a fraction of it
  double bow = 0.01;             // metres, of walls
};

struct StreetPulse {
  Ray ray;                   // street coordinates
  Vec3 right, up;            // across the ray
  double time = 0;           // seconds
  std::uint16_t visit = 1;   // pass of the vehicle, station, or flight line: what moves differs between them
  std::uint16_t source = 1;  // as in the record
  double gps_time = 0;
  double angle_deg = 0;
  Vec3 shift;  // error of the scanner's place
  Rng rng{0};
};

struct WildEcho {
  double range = 0;          // metres, without noise
  double surface_range = 0;  // of the surface whose label it has
  double cosine = 1;
  SurfaceLabel label;  // true_class 0 = mixed
};

// Says where a moving object is, relative to its base, or that it is not there.
struct WildMotion {
  Vec3 velocity;
  double at_base = 0;  // seconds
  bool comes_and_goes = false;
  bool jumps = false;  // from the air: it is somewhere else in each flight line
  std::uint64_t key = 0;
  double sweep = 0;  // seconds that a station scans; it passes at a moment of its own for each station
};
std::optional<Vec3> offset_at(const WildMotion& motion, double time, std::uint16_t visit);

// Everything that tracers share. It keeps views of the model.
class WildOptics {
 public:
  WildOptics(const WildStreetModel& model, const WildBeam& beam, std::vector<WildMotion> motions, Vec3 anchor,
             std::uint64_t seed);

  const WildStreetModel& model() const { return model_; }
  const WildBeam& beam() const { return beam_; }

 private:
  friend class WildTracer;
  const WildStreetModel& model_;
  WildBeam beam_;
  std::vector<WildMotion> motions_;  // of model.moving
  std::vector<Crown> crowns_;
  PartScene parts_;
  RayScene leaves_;
  std::uint64_t seed_;
};

// Keeps its own memory, so each thread needs one.
class WildTracer {
 public:
  explicit WildTracer(const WildOptics& optics) : optics_(optics) {}

  // Finds the echoes of a pulse, nearest first, at most five.
  void trace(StreetPulse& pulse, std::vector<WildEcho>& echoes);

  // Returns the element of the first solid that a ray meets within its range; 0 = none. Panes count as solid.
  std::uint32_t element_met(const Ray& ray, double time, std::uint16_t visit);

 private:
  struct Met {
    double range = 0, cosine = 1;
    SurfaceId surface = 0;
  };
  std::optional<Met> nearest(const Ray& ray, double from, double time, std::uint16_t visit) const;
  std::optional<Met> solid_echo(const Ray& ray, double chance, const StreetPulse& pulse) const;
  bool is_lost(const Met& met, Vec3 place, double chance) const;
  double relief(const SurfaceLabel& label, Vec3 place, double cosine) const;
  double leaf_chance(const LeafBall& ball, Vec3 place) const;
  void add_leaves(StreetPulse& pulse, double farthest, std::vector<WildEcho>& echoes);
  WildEcho echo_of(const Met& met, const Ray& ray) const;

  const WildOptics& optics_;
  std::vector<Candidate> candidates_;
  CastResult crossed_;
};

}  // namespace ilot::scan
