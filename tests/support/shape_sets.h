// SPDX-License-Identifier: Apache-2.0
// Points on spheres, cylinders, cones and planes with noise along the normal.
#pragma once
#include "kernels/shapes/shape.h"
#include "tests/support/oriented_sets.h"

namespace ilot::test {

// Returns a point on the shape. `turn` is in [0, 1) around the axis and `along` is measured from the origin (sphere:
// height in [-1, 1] radii). Planes are not supported. Tests may call the maths library.
inline std::pair<Vec3, Vec3> point_on(const Shape& s, double turn, double along) {
  const Vec3 a = std::abs(s.axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  Vec3 e1 = cross(s.axis, a);
  e1 = (1 / norm(e1)) * e1;
  const Vec3 e2 = cross(s.axis, e1);
  const double angle = 6.283185307179586 * turn;
  const Vec3 out = std::cos(angle) * e1 + std::sin(angle) * e2;
  if (s.kind == ShapeKind::kSphere) {
    const double w = std::sqrt(std::max(0.0, 1 - along * along));
    const Vec3 n = w * out + along * s.axis;
    return {s.origin + s.radius * n, n};
  }
  if (s.kind == ShapeKind::kCylinder) return {s.origin + along * s.axis + s.radius * out, out};
  const double across = along * s.sine / s.cosine;
  return {s.origin + along * s.axis + across * out, s.cosine * out - s.sine * s.axis};
}

// Adds n points with turn in [0, arc) and along in [from, to). They are uniform in area for spheres and cylinders.
inline void add_shape(OrientedSetBuilder& b, Rng& rng, const Shape& s, int n, double arc, double from, double to,
                      double noise) {
  for (int i = 0; i < n; ++i) {
    double along = from + (to - from) * rng.uniform();
    if (s.kind == ShapeKind::kCone)  // more points where it is wide
      along = std::sqrt(from * from + (to * to - from * from) * rng.uniform());
    const auto [p, normal] = point_on(s, arc * rng.uniform(), along);
    b.add(p + noise * bell(rng) * normal, normal);
  }
}

inline Shape sphere(Vec3 centre, double radius) {
  return {ShapeKind::kSphere, centre, {0, 0, 1}, radius};
}
inline Shape cylinder(Vec3 origin, Vec3 axis, double radius) {
  return {ShapeKind::kCylinder, origin, (1 / norm(axis)) * axis, radius};
}
inline Shape cone(Vec3 apex, Vec3 axis, double slope) {  // slope: tangent of the half angle
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  return {ShapeKind::kCone, apex, (1 / norm(axis)) * axis, 0, slope * cosine, cosine};
}

}  // namespace ilot::test
