// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scan/optics/solid.h"

namespace ilot::scan {

struct SolidHit {
  double t = 0;
  std::uint32_t face = 0;  // number in the list of faces of the scene
};

struct CrownHit {
  std::uint32_t crown = 0;
  Chord chord;
};

struct CastResult {
  std::optional<SolidHit> solid;  // the nearest face
  std::vector<CrownHit> crowns;   // those the ray crosses anywhere along it, by rising number
};

// Finds what rays meet among many solids and crowns. Embree only culls, with boxes grown beyond the rounding
// of its floats; the hit is decided in double by enter() and cross(), ties by the smaller face, so that
// results do not depend on the instruction set Embree chose. Keeps views of the solids and crowns: they must
// outlive it. Several threads may cast at once. Coordinates may lie anywhere; extents around the anchor must
// stay below 4 km.
class RayScene {
 public:
  RayScene(std::span<const ConvexSolid> solids, std::span<const Crown> crowns, Vec3 anchor);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  // The result is passed in so that its memory is reused from ray to ray.
  void cast(const Ray& ray, CastResult& result) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot::scan
