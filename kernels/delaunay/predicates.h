// SPDX-License-Identifier: Apache-2.0
// Exact predicates of the plane. Coordinates are integers on a lattice, so 64 and 128 bits are enough for every
// determinant. There is no filter, no expansion and no rounding.
#pragma once
#include <cstdint>

#include "kernels/geometry/point2.h"

namespace ilot {

namespace detail {
// The tie of four points on one circle: the largest in (x, y) counts as just outside of the circle through the others.
constexpr bool in_circle_tie(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (a < d && b < d && c < d) return false;
  if (b < a && c < a) return orient2d(b, c, d) > 0;
  if (c < b) return orient2d(c, a, d) > 0;
  return orient2d(a, b, d) > 0;
}
}  // namespace detail

// Where d is relative to the circle through a, b, c, which turn left: 1 inside, 0 on it, -1 outside.
constexpr int in_circle_sign(Point2 a, Point2 b, Point2 c, Point2 d) {
  const std::int64_t ax = a.x - d.x, ay = a.y - d.y;
  const std::int64_t bx = b.x - d.x, by = b.y - d.y;
  const std::int64_t cx = c.x - d.x, cy = c.y - d.y;
  const __int128 sum = static_cast<__int128>(ax * ax + ay * ay) * (bx * cy - by * cx) +
                       static_cast<__int128>(bx * bx + by * by) * (cx * ay - cy * ax) +
                       static_cast<__int128>(cx * cx + cy * cy) * (ax * by - ay * bx);
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

// The same without ties. d is none of the three. Four points on a circle are decided by symbolic perturbation of the
// paraboloid: each point is lifted by an infinitesimal that outweighs those of all points smaller in (x, y)
// (Edelsbrunner, Muecke 1990). So the result depends on the four points alone and not on their order or on a common
// shift. The triangulation without any point in any circle is unique.
constexpr bool in_circle(Point2 a, Point2 b, Point2 c, Point2 d) {
  const int sign = in_circle_sign(a, b, c, d);
  return sign != 0 ? sign > 0 : detail::in_circle_tie(a, b, c, d);
}

}  // namespace ilot
