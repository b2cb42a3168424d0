// SPDX-License-Identifier: Apache-2.0
// Points and edges of a plane in doubles, for measuring. Exact geometry of the plane has lattice points of its own
// (kernels/delaunay/predicates.h).
#pragma once

namespace ilot {

struct FlatPoint {
  double x = 0, y = 0;
};

struct FlatEdge {
  FlatPoint a, b;
};

}  // namespace ilot
