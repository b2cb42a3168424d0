// SPDX-License-Identifier: Apache-2.0
// How two solids lie to each other, from their boundaries: each triangle of one is cut where the other's surface meets
// its plane, and every piece lies in the other, outside of it, or on its surface.
#pragma once
#include <span>
#include <vector>

#include "kernels/meshes/manifold.h"

namespace ilot {

// A closed boundary whose triangles turn left seen from outside of what is solid.
struct SolidBoundary {
  std::vector<Index3> vertices;
  std::vector<TriangleCorners> triangles;
};

struct SolidRelation {
  bool a_inside_b = false, a_outside_b = false;  // some piece of a's boundary is
  bool b_inside_a = false, b_outside_a = false;
  bool share_same = false;      // some surface with both solids on one side of it
  bool share_opposite = false;  // some surface with the solids on its two sides

  bool interiors_overlap() const { return a_inside_b || b_inside_a || share_same; }
  bool equal() const {
    return share_same && !share_opposite && !a_inside_b && !a_outside_b && !b_inside_a && !b_outside_a;
  }
};

// Pieces under a square of 100 steps and surfaces nearer than two steps count as none: a tenth of a millimetre and two
// micrometres. Vertices of both on one lattice. O(triangles of a x those of b), with boxes first. Both have
// triangles.
SolidRelation relate_solids(const SolidBoundary& a, const SolidBoundary& b);

}  // namespace ilot
