// SPDX-License-Identifier: Apache-2.0
// Flat faces cut by a plane.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/flat.h"

namespace ilot {

// A planar polygon: the outer ring, then holes; the last corner not repeated.
struct SectionFace {
  std::vector<std::vector<Vec3>> rings;
};

// A plane and its axes, of unit length and at right angles: u to the right of the drawing, v up. What lies beyond an
// end along u is not cut.
struct SectionPlane {
  Vec3 origin, u{1, 0, 0}, v{0, 1, 0};
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

// Where the plane passes through the faces, in its axes: stretches inside each face (even-odd rule), face by face,
// along the cut. Corners that lie in the plane count as in front of it, so that a ring is crossed an even number of
// times; a face that lies in the plane gives nothing. O(corners), O(k log k) for a face that is crossed k times.
std::vector<FlatEdge> cut_faces(std::span<const SectionFace> faces, const SectionPlane& plane);

// Stretches joined where their ends are at most `touch` apart, each end with the nearest free one (ties: the earlier):
// lists of corners, the first repeated at the end of those that close. Stretches shorter than `touch` are left out.
// O(n log n) for ends spread wider than `touch`.
std::vector<std::vector<FlatPoint>> join_stretches(std::span<const FlatEdge> edges, double touch);

}  // namespace ilot
