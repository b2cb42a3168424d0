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
  std::vector<CrownHit> crowns;   // all crowns that the ray crosses anywhere along it, in increasing order
};

// Finds what rays meet among many solids and crowns. Embree only culls, with boxes that are grown beyond the rounding
// of its floats. enter() and cross() decide the hit in double. Ties go to the smaller face, so results do not depend on
// the instruction set that Embree chooses. The scene keeps views of the solids and crowns, so these must outlive it.
// Several threads may cast at once. Coordinates may have any size, but extents around the anchor must be below 4 km.
class RayScene {
 public:
  RayScene(std::span<const ConvexSolid> solids, std::span<const Crown> crowns, Vec3 anchor);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  // The result is an argument so that its memory is reused from ray to ray.
  void cast(const Ray& ray, CastResult& result) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot::scan
