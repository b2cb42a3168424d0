// SPDX-License-Identifier: Apache-2.0
// From the ragged boundary of a point cloud to the outline that somebody built [Boltcheva et al. 2019, 3.3.2].
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

struct RegulariseParams {
  double tolerance = 0;  // lattice units, above 0; about the sampling step: boundary points stray from their edge by it
  double outwards = 0;   // lattice units; edges move out by at most this, half a step: points end so far inside of them
};

// One polygon: its outer ring first, counter-clockwise, then holes, clockwise, as alpha shapes give them. Boundary
// points are split into edges at a distance tolerance (Douglas, Peucker 1973), a line is fitted to each by total least
// squares, lines that a turn within the tolerance makes parallel or square to a main direction of the polygon are
// turned so, lines that go on along each other within the tolerance become one or are joined by a step square to them,
// short cuts across a corner are taken out. Main directions are those that most of the length agrees on, up to three;
// edges that agree with none keep their own. Edges move out by the root of 3 times the scatter of their boundary
// points: by half a step where points end anywhere within a step of the edge, by nothing where they lie on it. The
// result is never self-crossing: the same order and sense of rings, at least a unit between vertices; where it would
// be, the edges stay where the points are, and where that fails too the boundary is only thinned within the tolerance.
// Holes that vanish are left out. A function of the rings alone, moving along with a shift of them. O(n log n) in
// boundary points, O(edges^2).
std::vector<std::vector<Point2>> regularise(std::span<const std::vector<Point2>> rings, const RegulariseParams& params);

}  // namespace ilot
