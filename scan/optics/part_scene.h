// SPDX-License-Identifier: Apache-2.0
// A static scene made of parts, and the search for what a ray meets in it.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "kernels/geometry/box3.h"
#include "scan/optics/material.h"
#include "scan/optics/part.h"

namespace ilot::scan {

// The labels of a point on a surface.
struct SurfaceLabel {
  std::uint8_t true_class = 0;
  std::uint32_t plane = 0;    // true_plane: id of a plane or a shape, 0 = none
  std::uint32_t element = 0;  // true_element, 0 = none
  Material material = Material::render;
  std::uint8_t tone = 0;  // shades of the material's colour: 0 = the colour itself
};

struct SceneModel {
  std::vector<Part> parts;
  std::vector<SurfaceLabel> surfaces;  // by SurfaceId

  SurfaceId add_surface(const SurfaceLabel& label) {
    surfaces.push_back(label);
    return static_cast<SurfaceId>(surfaces.size() - 1);
  }
};

Box3<Vec3> bounds_of(std::span<const Part> parts);

// A part that a ray may meet. The ray does not meet it before the distance `enters`.
struct Candidate {
  double enters = 0;
  std::uint32_t part = 0;
};

// Embree only culls. It uses the boxes of the parts, which are grown beyond the rounding of its floats. meet() decides
// in double what a ray hits. Ties go to the smaller index, so results do not depend on the instruction set that Embree
// chooses. The scene keeps a view of the parts, so the parts must outlive it. Several threads may query it at once.
// Coordinates may have any size, but extents must be below 4 km.
class PartScene {
 public:
  // `reach` is a distance in metres. Rays within this distance of another ray share its candidates: the rays of a beam
  // share those of its axis. The condition is that each of their points is at most `reach` from the point of the axis
  // at the same length.
  explicit PartScene(std::span<const Part> parts, double reach = 0);
  ~PartScene();
  PartScene(const PartScene&) = delete;
  PartScene& operator=(const PartScene&) = delete;

  // Finds all parts that the ray, or a ray within reach of it, may meet anywhere along it. They are sorted by the
  // distance at which their boxes begin, then by index. The memory of `out` is reused.
  void candidates(const Ray& ray, std::vector<Candidate>& out) const;

  // Returns the hit with the nearest of these parts beyond `from`. The search stops where the next box begins behind
  // that hit.
  std::optional<PartHit> nearest(const Ray& ray, std::span<const Candidate> candidates, double from = 0) const;

  // Runs candidates() and nearest() in one call.
  std::optional<PartHit> cast(const Ray& ray, double from = 0) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot::scan
