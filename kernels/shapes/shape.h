// SPDX-License-Identifier: Apache-2.0
// Planes, spheres, cylinders and cones in one form: an origin, an axis, and a radius or an angle.
#pragma once
#include <cmath>
#include <cstdint>

#include "kernels/core/types.h"

namespace ilot {

enum class ShapeKind : std::uint8_t { kPlane, kSphere, kCylinder, kCone };  // from the simplest to the most complex
constexpr int kShapeKinds = 4;

// A shape in the frame and the units of the points.
//   plane     origin: a point of it, axis: its normal
//   sphere    origin: its centre
//   cylinder  origin: a point of its axis
//   cone      origin: its apex; the axis points into the one nappe that counts
struct Shape {
  ShapeKind kind = ShapeKind::kPlane;
  Vec3 origin;
  Vec3 axis{0, 0, 1};           // unit; a sphere does not use it
  double radius = 0;            // sphere, cylinder
  double sine = 0, cosine = 1;  // of a cone's half angle
};

// The signed distance of a point from a shape and the surface normal there. The distance is positive outside; for a
// plane it is positive along its normal. It never changes by more than the point moves: |distance(p) - distance(q)| <=
// |p - q|. Behind the apex of a cone it is the distance to the tangent plane, which is at most the true distance. On an
// axis or at a centre, where every direction is normal, the normal is zero.
struct ShapeView {
  double distance = 0;
  Vec3 normal;
};

inline ShapeView view_of(const Shape& s, Vec3 p) {
  const Vec3 v = p - s.origin;
  if (s.kind == ShapeKind::kPlane) return {dot(v, s.axis), s.axis};
  const double h = s.kind == ShapeKind::kSphere ? 0 : dot(v, s.axis);
  const Vec3 q = v - h * s.axis;
  const double across = norm(q);
  const Vec3 out = across > 0 ? (1 / across) * q : Vec3{};
  if (s.kind == ShapeKind::kCone)
    return {across * s.cosine - h * s.sine, across > 0 ? s.cosine * out - s.sine * s.axis : Vec3{}};
  return {across - s.radius, out};
}

inline Shape shape_of(const Plane& plane) {
  return {ShapeKind::kPlane, -plane.d * plane.n, plane.n};
}
// The plane of a shape of kind plane. Its normal points up.
inline Plane plane_of(const Shape& s) {
  const Vec3 n = s.axis;
  const bool down = n.z < 0 || (n.z == 0 && (n.y < 0 || (n.y == 0 && n.x < 0)));
  const Vec3 up = down ? -1.0 * n : n;
  return {up, -dot(up, s.origin)};
}

}  // namespace ilot
