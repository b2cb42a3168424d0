// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/roofs/faces/roof_planes.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "kernels/geometry/flat.h"

namespace ilot {

// The least difference of slope of two planes whose intersection is a line.
// Derived: 3 degrees; flatter creases are within the noise of planes.
constexpr double kLeastSlopeChange = 0.05;

// A place on the border of two planes.
struct BorderSample {
  FlatPoint at;
  std::uint32_t a = 0, b = 0;  // planes, a < b
  FlatPoint upper, lower;      // the points between which it was seen
};

struct Borders {
  std::vector<BorderSample> creases, steps;
};

// Returns the places where neighbouring points lie on different planes: where the planes meet within a step of it, a
// sample of a crease; elsewhere a sample of a step. Neighbours are those of the Delaunay triangulation of the points in
// plan. O(n log n).
Borders find_borders(const RoofSite& site, const RoofPlanes& planes);

}  // namespace ilot
