// SPDX-License-Identifier: Apache-2.0
// A scene that stands still, made of parts, and what rays meet in it.
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

// What a point on a surface is.
struct SurfaceLabel {
  std::uint8_t true_class = 0;
  std::uint32_t plane = 0;    // true_plane: id of a plane or a shape, 0 = none
  std::uint32_t element = 0;  // true_element, 0 = none
  Material material = Material::render;
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

// A part that a ray may meet, not before `enters` along it.
struct Candidate {
  double enters = 0;
  std::uint32_t part = 0;
};

// Embree only culls, with the boxes of the parts grown beyond the rounding of its floats; what is met is decided in
// double by meet(), ties by the smaller index, so that results do not depend on the instruction set Embree chose. Keeps
// a view of the parts: they must outlive it. Several threads may ask at once. Coordinates may lie anywhere; extents
// must stay below 4 km.
class PartScene {
 public:
  // reach: metres within which rays beside another share its candidates: those of a beam those of its axis, as long as
  // no point of theirs is further than that from the axis's point at the same length.
  explicit PartScene(std::span<const Part> parts, double reach = 0);
  ~PartScene();
  PartScene(const PartScene&) = delete;
  PartScene& operator=(const PartScene&) = delete;

  // All parts that the ray, or one within reach of it, may meet anywhere along it, by the place where their boxes
  // begin, then by index. Memory of `out` is reused.
  void candidates(const Ray& ray, std::vector<Candidate>& out) const;

  // The nearest of these parts beyond `from`; stops where the next box begins behind it.
  std::optional<PartHit> nearest(const Ray& ray, std::span<const Candidate> candidates, double from = 0) const;

  // Both in one.
  std::optional<PartHit> cast(const Ray& ray, double from = 0) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot::scan
