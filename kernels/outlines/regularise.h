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
// them. Main directions are the directions of most of the length, at most three, each with the one across it. They are
// found on parts of the boundary that are straight within the tolerance (Douglas, Peucker 1973). The boundary points
// are then divided into sides so that a list of the sides and of the points beside them is shortest (side_split.h): a
// side along a main direction costs less than one in a direction of its own, and the line of that one is fitted by
// total least squares. Parallel sides that follow each other are joined by a step perpendicular to them. Corners are
// where lines meet, so inner corners that the boundary cuts across are whole. Edges move out by the root of 3 times the
// scatter of their boundary points. This is half a step where points end anywhere within a step of the edge, and zero
// where they are on it. The result never crosses itself. The rings keep their order and orientation, and vertices are
// at least one unit apart. Where the result would cross itself, the edges are not moved out. Where that fails too, the
// boundary is only thinned within the tolerance. Holes that vanish are left out. The result depends on the rings alone
// and moves with them. O(boundary points x points of a side).
std::vector<std::vector<Point2>> regularise(std::span<const std::vector<Point2>> rings, const RegulariseParams& params);

}  // namespace ilot
