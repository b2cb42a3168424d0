// SPDX-License-Identifier: Apache-2.0
// Overlay of areas in a plane by GEOS. Rings that cross themselves are repaired (MakeValid).
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

// Whether p is in the ring and in no hole. O(corners).
bool contains(const FlatPolygon& polygon, FlatPoint p);

// Polygons that are prepared for comparison. Copies share their data. Not for use by two threads at once.
class FlatArea {
 public:
  // Builds the union of the polygons; rings with fewer than three corners are left out. A `grid` > 0 first moves
  // corners onto multiples of it, so that neighbours with a gap smaller than that become one.
  explicit FlatArea(std::span<const FlatPolygon> polygons, double grid = 0);

  double area() const;
  double common_area(const FlatArea& other) const;
  std::vector<FlatEdge> edges() const;  // of all rings

  // The same area with fewer corners: none moves farther than `tolerance`, and no ring crosses another.
  FlatArea simplified(double tolerance) const;

  // The parts, in an order and from corners that depend on the area alone. Outer rings turn left, holes turn right.
  std::vector<FlatPolygon> polygons() const;

  // The outer ring of the largest polygon, not closed. Empty when there is no area.
  std::vector<FlatPoint> largest_ring() const;

 private:
  struct Geometry;
  FlatArea(const FlatArea& whole, double tolerance);
  std::shared_ptr<const Geometry> geometry_;
};

// The common area divided by the area of both together; 0 when both are empty.
double intersection_over_union(const FlatArea& a, const FlatArea& b);

}  // namespace ilot
