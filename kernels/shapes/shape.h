// SPDX-License-Identifier: Apache-2.0
// Planes, spheres, cylinders and cones in one form: an origin, an axis, and a radius or an angle.
#pragma once
#include <cmath>
#include <cstdint>

#include "kernels/core/types.h"

namespace ilot {

enum class ShapeKind : std::uint8_t { kPlane, kSphere, kCylinder, kCone };  // the simplest first
constexpr int kShapeKinds = 4;

// In the frame and the units of the points.
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

// How a shape is seen from a point: the signed distance (outside positive; along a plane's normal) and the surface
// normal there. Never farther than the point moves: |distance(p) - distance(q)| <= |p - q|. Behind a cone's apex the
// distance is to the tangent plane, at most the true one. On an axis or a centre, where every direction is normal, the
// normal is zero.
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
// Of a shape of kind plane; the normal points up.
inline Plane plane_of(const Shape& s) {
  const Vec3 n = s.axis;
  const bool down = n.z < 0 || (n.z == 0 && (n.y < 0 || (n.y == 0 && n.x < 0)));
  const Vec3 up = down ? -1.0 * n : n;
  return {up, -dot(up, s.origin)};
}

}  // namespace ilot
