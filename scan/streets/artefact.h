// SPDX-License-Identifier: Apache-2.0
// The objects of a street: cars, lampposts, pedestrians and others. Each class has several variants, built from boxes,
// prisms, cylinders, cones and spheres.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/core/rng.h"
#include "kernels/geometry/box3.h"
#include "scan/optics/material.h"
#include "scan/optics/part.h"

namespace ilot::scan {

enum class ArtefactClass : std::uint8_t { car, lamppost, pedestrian, other };
const char* name_of(ArtefactClass artefact_class);

// An object in its own frame: x ahead, y to the left, z up. It stands on z = 0 around the origin. The surface ids of
// the solids are values of Material.
struct Artefact {
  std::vector<Solid> solids;

  void box(Vec3 centre, Vec3 size, Material material);
  // Adds a convex outline in the plane x z, swept over the width about y = 0. Faces are numbered as those of prism().
  Solid& profile(std::span<const FlatPoint> outline, double width, Material material);
  // Adds a convex outline in the plane x y, from one height to another.
  void column(std::span<const FlatPoint> outline, double from, double to, Material material);
  void rod(Vec3 from, Vec3 to, double radius, Material material);  // a cylinder between two positions
  void disc(Vec3 centre, Vec3 axis, double thickness, double radius, Material material);
  void ball(Vec3 centre, double radius, Material material);
  // Adds a cone about z that narrows from one radius at the bottom to another, smaller one at the top.
  void taper(Vec3 base, double height, double bottom_radius, double top_radius, Material material);
};

Box3<Vec3> bounds_of(const Artefact& artefact);

// Returns the names of the variants of a class, at least five. A variant of `other` is listed as often as it occurs
// among 144 objects.
std::span<const std::string_view> variants_of(ArtefactClass artefact_class);

// Makes an object. Draws the sizes that differ within a variant. The variant must belong to the class.
Artefact make_artefact(ArtefactClass artefact_class, std::string_view variant, Rng& rng);

// The four functions that make_artefact() calls.
Artefact make_car(std::string_view variant, Rng& rng);
Artefact make_lamppost(std::string_view variant, Rng& rng);
Artefact make_pedestrian(std::string_view variant, Rng& rng);
Artefact make_furniture(std::string_view variant, Rng& rng);

}  // namespace ilot::scan
