// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/solid.h"

#include <cmath>
#include <limits>

namespace ilot::scan {

std::optional<FaceHit> enter(const Ray& ray, const ConvexSolid& solid) {
  double leave = std::numeric_limits<double>::infinity();
  FaceHit hit{-leave, 0};
  for (std::uint32_t i = 0; i < solid.face_count; ++i) {
    const Plane& plane = solid.planes[i];
    const double rate = dot(plane.n, ray.direction);
    const double distance = signed_distance(plane, ray.origin);
    if (rate == 0) {
      if (distance > 0) return std::nullopt;
      continue;
    }
    const double t = -distance / rate;
    if (rate < 0 && t > hit.t) hit = {t, i};
    if (rate > 0 && t < leave) leave = t;
    if (hit.t > leave) return std::nullopt;
  }
  if (!(hit.t > 0)) return std::nullopt;
  return hit;
}

std::optional<Chord> cross(const Ray& ray, const Crown& crown) {
  const auto scaled = [&](Vec3 v) { return Vec3{v.x / crown.radii.x, v.y / crown.radii.y, v.z / crown.radii.z}; };
  const Vec3 origin = scaled(ray.origin - crown.centre);
  const Vec3 direction = scaled(ray.direction);
  const double a = dot(direction, direction);
  const double half_b = dot(origin, direction);
  const double discriminant = half_b * half_b - a * (dot(origin, origin) - 1);
  if (!(discriminant > 0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  return Chord{(-half_b - root) / a, (-half_b + root) / a};
}

}  // namespace ilot::scan
