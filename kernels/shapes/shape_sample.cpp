// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_sample.h"

namespace ilot {
namespace {

// Derived: 6 degrees; at less, noise turns the axis freely.
constexpr double kThinnest = 0.1;  // sine of the smallest angle between directions that count as different

std::optional<Vec3> unit(Vec3 v) {
  const double length = norm(v);
  if (!(length > 0)) return std::nullopt;
  return (1 / length) * v;
}

}  // namespace

std::optional<Shape> plane_through(const ShapeSample& s) {
  const Vec3 a = s[1].p - s[0].p, b = s[2].p - s[0].p;
  const Vec3 n = cross(a, b);
  if (!(norm(n) > kThinnest * norm(a) * norm(b))) return std::nullopt;
  const auto axis = unit(n);
  if (!axis) return std::nullopt;
  return Shape{ShapeKind::kPlane, s[0].p, *axis};
}

std::optional<Shape> sphere_through(const ShapeSample& s) {
  const Vec3 between = s[1].p - s[0].p;
  const double c = dot(s[0].n, s[1].n), sine2 = 1 - c * c;
  if (!(sine2 > kThinnest * kThinnest)) return std::nullopt;
  // The feet of the shortest segment between the two normals.
  const double d0 = dot(between, s[0].n), d1 = dot(between, s[1].n);
  const double t0 = (d0 - c * d1) / sine2, t1 = (c * d0 - d1) / sine2;
  const Vec3 centre = 0.5 * ((s[0].p + t0 * s[0].n) + (s[1].p + t1 * s[1].n));
  const double radius = 0.5 * (norm(s[0].p - centre) + norm(s[1].p - centre));
  if (!(radius > 0)) return std::nullopt;
  return Shape{ShapeKind::kSphere, centre, {0, 0, 1}, radius};
}

std::optional<Shape> cylinder_through(const ShapeSample& s) {
  const Vec3 across = cross(s[0].n, s[1].n);
  if (!(norm(across) > kThinnest)) return std::nullopt;
  const Vec3 axis = (1 / norm(across)) * across;
  // In the plane perpendicular to the axis, the two normals are lines that meet in the centre.
  const Vec3 between = s[1].p - s[0].p;
  const Vec3 flat = between - dot(between, axis) * axis;
  const Vec3 side = cross(axis, s[1].n);
  const double t = dot(flat, side) / dot(s[0].n, side);
  const Vec3 centre = s[0].p + t * s[0].n;
  const Vec3 other = flat - t * s[0].n;
  const double radius = 0.5 * (std::abs(t) + norm(other));
  if (!(radius > 0)) return std::nullopt;
  return Shape{ShapeKind::kCylinder, centre, axis, radius};
}

std::optional<Shape> cone_through(const ShapeSample& s) {
  const Vec3 n01 = cross(s[0].n, s[1].n), n12 = cross(s[1].n, s[2].n), n20 = cross(s[2].n, s[0].n);
  const double det = dot(s[0].n, n12);
  if (!(std::abs(det) > kThinnest * kThinnest)) return std::nullopt;
  const double d0 = dot(s[0].p, s[0].n), d1 = dot(s[1].p, s[1].n), d2 = dot(s[2].p, s[2].n);
  const Vec3 apex = (1 / det) * (d0 * n12 + d1 * n20 + d2 * n01);
  std::array<Vec3, 3> ray;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto r = unit(s[i].p - apex);
    if (!r) return std::nullopt;
    ray[i] = *r;
  }
  // Unit vectors along the rays end on a circle around the axis.
  auto axis = unit(cross(ray[1] - ray[0], ray[2] - ray[0]));
  if (!axis) return std::nullopt;
  double cosine = (dot(*axis, ray[0]) + dot(*axis, ray[1]) + dot(*axis, ray[2])) / 3;
  if (cosine < 0) {
    axis = -1.0 * *axis;
    cosine = -cosine;
  }
  // The angle must be between 3 and 80 degrees. A narrower cone looks like a cylinder, a wider one like a plane.
  if (!(cosine > 0.17 && cosine < 0.9986)) return std::nullopt;
  return Shape{ShapeKind::kCone, apex, *axis, 0, std::sqrt(1 - cosine * cosine), cosine};
}

std::optional<Shape> sample_shape(ShapeKind kind, const ShapeSample& s, double epsilon, double min_cos) {
  const auto shape = [&] {
    switch (kind) {
      case ShapeKind::kSphere:
        return sphere_through(s);
      case ShapeKind::kCylinder:
        return cylinder_through(s);
      case ShapeKind::kCone:
        return cone_through(s);
      case ShapeKind::kPlane:
      default:
        return plane_through(s);
    }
  }();
  if (!shape) return std::nullopt;
  for (const OrientedPoint& q : s) {
    const ShapeView v = view_of(*shape, q.p);
    if (!(std::abs(v.distance) <= epsilon) || std::abs(dot(v.normal, q.n)) < min_cos) return std::nullopt;
  }
  return shape;
}

}  // namespace ilot
