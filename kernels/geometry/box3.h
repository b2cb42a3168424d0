// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>

#include "kernels/core/types.h"

namespace ilot {

// A closed, axis-parallel box in space. It is empty when any max < min. Point is Vec3, Index3 or another type with x, y
// and z.
template <class Point>
struct Box3 {
  using Number = decltype(Point::x);

  Point min, max;

  // The empty box, from which add() starts.
  static constexpr Box3 none() {
    using Limits = std::numeric_limits<Number>;
    constexpr Number kMost = Limits::has_infinity ? Limits::infinity() : Limits::max();
    constexpr Number kLeast = Limits::has_infinity ? -Limits::infinity() : Limits::lowest();
    return {{kMost, kMost, kMost}, {kLeast, kLeast, kLeast}};
  }
  bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  void add(const Point& p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
  }
  void add_box(const Box3& o) {
    min = {std::min(min.x, o.min.x), std::min(min.y, o.min.y), std::min(min.z, o.min.z)};
    max = {std::max(max.x, o.max.x), std::max(max.y, o.max.y), std::max(max.z, o.max.z)};
  }
  Box3 grown(Number by) const { return {{min.x - by, min.y - by, min.z - by}, {max.x + by, max.y + by, max.z + by}}; }
  bool contains(const Point& p) const {
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z && p.z <= max.z;
  }
  bool intersects(const Box3& o) const {
    return min.x <= o.max.x && o.min.x <= max.x && min.y <= o.max.y && o.min.y <= max.y && min.z <= o.max.z &&
           o.min.z <= max.z;
  }
  friend bool operator==(const Box3&, const Box3&) = default;
};

// A box of lattice points, in scale units.
using IndexBox = Box3<Index3>;

// A box that contains all heights over a closed rectangle of the ground.
inline IndexBox column_over(std::int64_t min_x, std::int64_t min_y, std::int64_t max_x, std::int64_t max_y) {
  constexpr std::int64_t kFar = std::int64_t{1} << 52;  // farther than any point of a cloud
  return {{min_x, min_y, -kFar}, {max_x, max_y, kFar}};
}

}  // namespace ilot
