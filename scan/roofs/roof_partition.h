// SPDX-License-Identifier: Apache-2.0
// A building is described by wings. Each wing stands on a rectangle of the footprint and ends in the lowest of its roof
// planes. Where wings overlap, the highest counts. Any roof without overhang can be composed in this way. Its view from
// above is a partition of the footprint into convex pieces with one plane each. The computation is exact: it uses
// integer millimetres, and slopes in sixteenths.
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

// A wing is convex: it is the prism over the rectangle below all of its planes.
struct Wing {
  GridRect rect;
  std::vector<RoofPlane> planes;
};

struct RoofPiece {
  Piece outline;
  RoofPlane plane;
};

// Returns what is visible of the wings from above. Every position is covered once. If planes are equal, the plane of
// the first wing is visible. Time grows with the square of the number of wings.
std::vector<RoofPiece> partition_roof(std::span<const Wing> wings);

// Returns the height in millimetres of a plane above a position, or of the lowest plane of a wing.
double height_mm(const RoofPlane& plane, double u, double v);
double height_mm(const Wing& wing, double u, double v);

}  // namespace ilot::scan
