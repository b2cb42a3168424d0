// SPDX-License-Identifier: Apache-2.0
// Computes how two solids are related, from their boundaries. Each triangle of one is cut where the other's surface
// meets its plane, and every piece is inside the other, outside of it, or on its surface.
#pragma once
#include <span>
#include <vector>

#include "kernels/meshes/manifold.h"

namespace ilot {

// A closed boundary. Its triangles are counter-clockwise as seen from outside of the solid.
struct SolidBoundary {
  std::vector<Index3> vertices;
  std::vector<TriangleCorners> triangles;
};

struct SolidRelation {
  bool a_inside_b = false, a_outside_b = false;  // a piece of a's boundary is inside or outside of b
  bool b_inside_a = false, b_outside_a = false;
  bool share_same = false;      // a common surface with both solids on the same side
  bool share_opposite = false;  // a common surface with the solids on opposite sides

  bool interiors_overlap() const { return a_inside_b || b_inside_a || share_same; }
  bool equal() const {
    return share_same && !share_opposite && !a_inside_b && !a_outside_b && !b_inside_a && !b_outside_a;
  }
};

// Relates two solids, which both have triangles, with vertices on one lattice. Pieces smaller than a square of 100
// steps and surfaces nearer than two steps are ignored: a tenth of a millimetre and two micrometres. O(triangles of a x
// those of b), with a box test first.
SolidRelation relate_solids(const SolidBoundary& a, const SolidBoundary& b);

}  // namespace ilot
