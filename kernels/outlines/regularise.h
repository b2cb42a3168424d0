// SPDX-License-Identifier: Apache-2.0
// From the irregular boundary of a point cloud to the outline as it was built [Boltcheva et al. 2019, 3.3.2].
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

struct RegulariseParams {
  double tolerance = 0;  // lattice units, above 0; about the sampling step, by which boundary points are off
  double outwards = 0;   // lattice units; edges move out by at most this, half a step: points end inside
};

// Regularises one polygon: its outer ring first, counter-clockwise, then the holes, clockwise, as alpha shapes give
// them. Boundary points are split into edges at a distance tolerance (Douglas, Peucker 1973). A line is fitted to each
// edge by total least squares. A line is turned parallel or perpendicular to a main direction of the polygon where the
// turn stays within the tolerance. Lines that continue each other within the tolerance become one, or are joined by a
// step perpendicular to them. Short cuts across a corner are removed.
// Main directions are the directions of most of the length, at most three. Edges that agree with none keep their own.
// Edges move out by the root of 3 times the scatter of their boundary points. This is half a step where points end
// anywhere within a step of the edge, and zero where they are on it.
// The result never crosses itself. The rings keep their order and orientation, and vertices are at least one unit
// apart. Where the result would cross itself, the edges are not moved out. Where that fails too, the boundary is only
// thinned within the tolerance. Holes that vanish are left out. The result depends on the rings alone and moves with
// them. O(n log n) in boundary points, O(edges^2).
std::vector<std::vector<Point2>> regularise(std::span<const std::vector<Point2>> rings, const RegulariseParams& params);

}  // namespace ilot
