// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "kernels/core/types.h"
#include "kernels/geometry/flat.h"

namespace ilot {

// Right-handed axes u, v in a plane, with an origin nearby.
struct FlatFrame {
  Vec3 origin, u, v;

  FlatPoint flat(Vec3 p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
};

// The frame of a plane. `normal` has unit length. u is perpendicular to the coordinate axis along which the normal has
// its smallest component.
inline FlatFrame plane_frame(Vec3 normal, Vec3 origin) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const Vec3 axis = z <= x && z <= y ? Vec3{0, 0, 1} : x <= y ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 across = cross(axis, normal);
  const Vec3 u = (1 / norm(across)) * across;
  return {origin, u, cross(normal, u)};
}

// The corners of a ring in the plane.
inline std::vector<FlatPoint> flattened(std::span<const Vec3> ring, const FlatFrame& frame) {
  std::vector<FlatPoint> flat;
  for (const Vec3& p : ring) flat.push_back(frame.flat(p));
  return flat;
}

}  // namespace ilot
