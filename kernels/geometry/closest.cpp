// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry/closest.h"

#include <algorithm>

namespace ilot {
namespace {

double squared(Vec3 v) {
  return dot(v, v);
}

Vec3 closest_on_edges(Vec3 p, const Triangle3& t) {
  Vec3 best = closest_on_segment(p, t.a, t.b);
  for (const Vec3 other : {closest_on_segment(p, t.b, t.c), closest_on_segment(p, t.c, t.a)})
    if (squared(p - other) < squared(p - best)) best = other;
  return best;
}

}  // namespace

Vec3 closest_on_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double length2 = squared(along);
  if (!(length2 > 0)) return a;
  return a + std::clamp(dot(p - a, along) / length2, 0.0, 1.0) * along;
}

Vec3 closest_on_triangle(Vec3 p, const Triangle3& t) {
  const Vec3 n = cross(t.b - t.a, t.c - t.a);
  const double n2 = squared(n);
  const Vec3 from_a = p - t.a, from_b = p - t.b, from_c = p - t.c;
  const bool inside = n2 > 0 && dot(cross(t.b - t.a, from_a), n) >= 0 && dot(cross(t.c - t.b, from_b), n) >= 0 &&
                      dot(cross(t.a - t.c, from_c), n) >= 0;
  if (!inside) return closest_on_edges(p, t);
  return p - (dot(from_a, n) / n2) * n;
}

}  // namespace ilot
