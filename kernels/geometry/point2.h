// SPDX-License-Identifier: Apache-2.0
// Points of a plane on an integer lattice. 64 bits are enough for every determinant of three of them, so there is no
// rounding.
#pragma once
#include <cmath>
#include <compare>
#include <cstdint>

#include "kernels/geometry/flat.h"

namespace ilot {

// A lattice point of a plane. Every coordinate lies within kMaxPlaneCoordinate of zero: 53 km at a tenth of a
// millimetre.
struct Point2 {
  std::int32_t x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
  friend auto operator<=>(const Point2&, const Point2&) = default;  // by x, then y
};

constexpr std::int32_t kMaxPlaneCoordinate = std::int32_t{1} << 29;

// Twice the signed area of the triangle, below 2^62. It is positive when a, b, c turn left.
constexpr std::int64_t orient2d(Point2 a, Point2 b, Point2 c) {
  return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) - static_cast<std::int64_t>(b.y - a.y) * (c.x - a.x);
}

constexpr std::int64_t squared_distance(Point2 a, Point2 b) {
  const std::int64_t x = a.x - b.x, y = a.y - b.y;
  return x * x + y * y;
}

// Returns the nearest point of a lattice with the given number of steps per unit. Halves are rounded away from zero.
// The result must be within the lattice.
inline Point2 lattice_point(FlatPoint p, double steps_per_unit) {
  return {static_cast<std::int32_t>(std::lround(p.x * steps_per_unit)),
          static_cast<std::int32_t>(std::lround(p.y * steps_per_unit))};
}

}  // namespace ilot
