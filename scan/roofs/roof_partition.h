// SPDX-License-Identifier: Apache-2.0
// A building as wings: each stands on a rectangle of the footprint and ends in the lowest of its roof planes; where
// wings overlap, the highest counts. So any roof without overhang can be put together, and what is seen of it from
// above is a partition of the footprint into convex pieces with a plane each. Exact: whole millimetres, slopes in
// sixteenths.
#pragma once
#include <span>
#include <vector>

#include "scan/optics/lattice_geometry.h"

namespace ilot::scan {

// 16 z = a u + b v + c.
struct RoofPlane {
  Integer a = 0, b = 0, c = 0;
  friend auto operator<=>(const RoofPlane&, const RoofPlane&) = default;
};
constexpr Integer kSlopeUnit = 16;

// Convex: it is the prism over the rectangle below all of its planes.
struct Wing {
  GridRect rect;
  std::vector<RoofPlane> planes;
};

struct RoofPiece {
  Piece outline;
  RoofPlane plane;
};

// What is seen of the wings from above, every place once. Of equal planes the first wing's is seen. Time grows with the
// square of the number of wings.
std::vector<RoofPiece> partition_roof(std::span<const Wing> wings);

// Height of a plane above a place in millimetres, and of the lowest plane of a wing.
double height_mm(const RoofPlane& plane, double u, double v);
double height_mm(const Wing& wing, double u, double v);

}  // namespace ilot::scan
