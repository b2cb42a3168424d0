// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <limits>

#include "kernels/geometry/flat.h"

namespace ilot {

// A closed, axis-parallel box in the plane.
struct FlatBox {
  FlatPoint min, max;

  // The empty box, from which add() starts.
  static constexpr FlatBox none() {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    return {{kFar, kFar}, {-kFar, -kFar}};
  }
  bool is_empty() const { return !(min.x <= max.x && min.y <= max.y); }
  double width() const { return max.x - min.x; }
  double height() const { return max.y - min.y; }
  FlatPoint middle() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
  void add(FlatPoint p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  void add_box(const FlatBox& o) {
    add(o.min);
    add(o.max);
  }
  FlatBox grown(double by) const { return {{min.x - by, min.y - by}, {max.x + by, max.y + by}}; }
  bool contains(FlatPoint p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
  bool contains(const FlatBox& o) const { return contains(o.min) && contains(o.max); }
  // Whether they have more than their borders in common.
  bool overlaps(const FlatBox& o) const {
    return min.x < o.max.x && o.min.x < max.x && min.y < o.max.y && o.min.y < max.y;
  }
};

}  // namespace ilot
