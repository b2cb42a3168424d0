// SPDX-License-Identifier: Apache-2.0
// The echoes of a pulse from above: first from crowns, which let a part of it through, then from a solid or the ground.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/optics/ray_scene.h"

namespace ilot::scan {

inline constexpr std::size_t kMaxEchoes = 5;  // of one pulse

struct PulseEcho {
  enum class From : std::uint8_t { ground, face, crown };
  double range = 0;  // metres, without noise
  From from = From::ground;
  std::uint32_t face = 0;  // number in the list of faces of the scene
};

// Finds the echoes of a pulse that crosses these crowns before it meets `last`, a solid or the ground. Nearest first,
// at least one and at most kMaxEchoes. `rng` decides what crowns let through.
void find_echoes(std::span<const CrownHit> crowns, const PulseEcho& last, Rng& rng, std::vector<PulseEcho>& echoes);

// Traces pulses over a plane of ground with solids and crowns on it. The scene must outlive the tracer. Each thread
// needs its own tracer; tracers may share the scene.
class PulseTracer {
 public:
  PulseTracer(const RayScene& scene, const Plane& ground) : scene_(scene), ground_(ground) {}

  // Finds the echoes as find_echoes does. The ray must point down.
  void trace(const Ray& ray, Rng& rng, std::vector<PulseEcho>& echoes);

 private:
  const RayScene& scene_;
  Plane ground_;
  CastResult found_;
};

}  // namespace ilot::scan
