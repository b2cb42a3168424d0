// SPDX-License-Identifier: Apache-2.0
// The objects that rays meet: convex solids with opaque faces, and tree crowns that let a part of the light through.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "kernels/core/types.h"
#include "kernels/geometry/box3.h"

namespace ilot::scan {

struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit length
};

inline Vec3 point_at(const Ray& ray, double t) {
  return ray.origin + t * ray.direction;
}

// The intersection of at most kMaxFaces half-spaces with outward normals. It may be open where no ray comes from (a
// house has no floor). The bounds must still contain all of the surface that can be seen.
struct ConvexSolid {
  static constexpr std::size_t kMaxFaces = 32;
  std::array<Plane, kMaxFaces> planes;
  std::uint32_t face_count = 0;
  std::uint32_t first_face = 0;  // number of its face 0 in the list of faces of the scene
  Box3<Vec3> bounds;
};

// An ellipsoid with axes along x, y, z.
struct Crown {
  Vec3 centre, radii;
};

struct FaceHit {
  double t = 0;
  std::uint32_t face = 0;  // within the solid; the smaller one on an edge
};

// Returns where the ray enters the solid. Returns nothing when the ray misses the solid or starts inside. The result is
// watertight: it is computed from the planes in double, so no ray passes between two faces.
std::optional<FaceHit> enter(const Ray& ray, const ConvexSolid& solid);

struct Chord {
  double enter = 0, leave = 0;
};

// Returns the part of the ray inside the crown. Returns nothing when the ray misses it.
std::optional<Chord> cross(const Ray& ray, const Crown& crown);

}  // namespace ilot::scan
