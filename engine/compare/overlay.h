// SPDX-License-Identifier: Apache-2.0
// Areas in a plane over each other, by GEOS. Rings that cross themselves are repaired (MakeValid).
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

struct FlatPolygon {
  std::vector<FlatPoint> ring;  // the last corner is not repeated
  std::vector<std::vector<FlatPoint>> holes;
};

// Polygons, made ready for comparison. Copies share; not for two threads at once.
class FlatArea {
 public:
  // The union of the polygons; rings with fewer than three corners are left out. `grid` > 0 moves corners onto
  // multiples of it first, so that neighbours that miss each other by less than that become one.
  explicit FlatArea(std::span<const FlatPolygon> polygons, double grid = 0);

  double area() const;
  double common_area(const FlatArea& other) const;
  std::vector<FlatEdge> edges() const;  // of all rings

 private:
  struct Geometry;
  std::shared_ptr<const Geometry> geometry_;
};

// Common area over the area of both together; 0 when both are empty.
double intersection_over_union(const FlatArea& a, const FlatArea& b);

}  // namespace ilot
