// SPDX-License-Identifier: Apache-2.0
// One pulse of a terrestrial scanner: the surfaces that its footprint touches and the echoes that come back.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/optics/part_scene.h"
#include "scan/scanners/station.h"

namespace ilot::scan {

// Surfaces farther from the scanner than this are ignored, unless the beam has a range of its own.
constexpr double kMaxRange = 300;  // metres

// What glass and the finish of a material do to a pulse. The rest of the pulses give an echo.
struct Transmission {
  double lost = 0;      // share of pulses that give no echo at all because they are mirrored away
  double through = 0;   // share that continues behind the surface
  double mirrored = 0;  // share whose echo comes over the mirror: it appears behind the surface, as a mirror image
};
Transmission transmission(Material material);

struct BeamParams {
  double range_noise = 0.002;      // metres, standard deviation along the beam
  double angle_noise_deg = 0.002;  // standard deviation about each of two axes
  double divergence_mrad = 0.2;    // full angle, 1/e2
  double diameter = 0.0045;        // metres, at the scanner, 1/e2
  double separation = 0.3;         // metres: closer echoes reach the receiver as one
  double farthest = kMaxRange;     // metres
  Transmission glass = transmission(Material::glass);
  double room = 0;  // metres: mean depth of rooms behind panes that a model does not have; 0 = no rooms
  // The surface of echoes that came by way of a mirror. Without it, mirrors give no echo.
  std::optional<SurfaceId> mirrored = std::nullopt;
};

// Radius of the footprint in metres.
inline double footprint_radius(const BeamParams& beam, double range) {
  return beam.diameter / 2 + beam.divergence_mrad * 0.0005 * range;
}

struct Echo {
  double range = 0;          // metres, with mixing, without noise
  double energy = 0;         // received: share of the light times reflectance times cosine of incidence
  SurfaceId surface = 0;     // the surface that gave most of the energy; pieces of one plane count as one
  double surface_range = 0;  // range of that surface; differs from range where the footprint mixes two surfaces
  double cosine = 1;         // of the incidence on that surface
  // The first surface that the pulse went through or that mirrored it. An echo from the back of a room that is not in
  // the model has this surface too.
  std::optional<SurfaceId> pane;
};

// Follows pulses through one scene. It keeps its own memory, so each thread needs one.
class BeamTracer {
 public:
  BeamTracer(const SceneModel& model, const PartScene& scene, const BeamParams& beam)
      : model_(model), scene_(scene), beam_(beam) {}

  // Finds the echoes of one pulse, nearest first. There are none when nothing comes back. rng decides where the beam
  // really points and what glass does. The footprint consists of seven rays: one along the axis and six around it, with
  // the weights of a Gaussian beam. The hits within the receiver's separation become one echo at the mean range,
  // weighted by energy.
  void trace(Vec3 origin, const Aim& aim, Rng& rng, std::vector<Echo>& echoes);

  // The first surface on the axis of the last pulse, whether or not it gave an echo.
  std::optional<SurfaceId> first_surface() const { return first_; }

 private:
  struct Touch {
    double range, energy;
    SurfaceId surface;
    double cosine;
    std::optional<SurfaceId> pane;
  };
  // What an echo by way of a mirror says: the surface it counts for, if not the one that it met, and the pane.
  struct MirrorImage {
    std::optional<SurfaceId> surface, pane;
  };
  Transmission way_of(Material material) const;
  double room_depth(SurfaceId pane) const;
  void follow_mirror(const Ray& ray, const PartHit& mirror, double weight, const MirrorImage& image);
  bool one_plane(SurfaceId a, SurfaceId b) const;
  void touch(const Ray& ray, double weight, double chance);
  void gather(std::vector<Echo>& echoes) const;

  const SceneModel& model_;
  const PartScene& scene_;
  BeamParams beam_;
  std::vector<Candidate> candidates_, mirrored_;
  std::vector<Touch> touches_;
  std::optional<SurfaceId> first_;
};

}  // namespace ilot::scan
