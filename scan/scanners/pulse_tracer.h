// SPDX-License-Identifier: Apache-2.0
// What comes back of a pulse from above: echoes from crowns that let part of it through, then from what is solid.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/optics/ray_scene.h"

namespace ilot::scan {

struct PulseEcho {
  enum class From : std::uint8_t { ground, face, crown };
  double range = 0;  // metres, without noise
  From from = From::ground;
  std::uint32_t face = 0;  // number in the list of faces of the scene
};

// The echoes of a pulse that meets these crowns on its way to what is solid, `last`: nearest first, at least one, at
// most five. `rng` decides what crowns let through.
void find_echoes(std::span<const CrownHit> crowns, const PulseEcho& last, Rng& rng, std::vector<PulseEcho>& echoes);

// Traces pulses over a plane of ground with solids and crowns on it. The scene must outlive it; several threads need a
// tracer each and may share the scene.
class PulseTracer {
 public:
  PulseTracer(const RayScene& scene, const Plane& ground) : scene_(scene), ground_(ground) {}

  // The echoes, as find_echoes has them. The ray points down.
  void trace(const Ray& ray, Rng& rng, std::vector<PulseEcho>& echoes);

 private:
  const RayScene& scene_;
  Plane ground_;
  CastResult found_;
};

}  // namespace ilot::scan
