// SPDX-License-Identifier: Apache-2.0
// Sections of flat faces by a plane.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/flat.h"

namespace ilot {

// A planar polygon: the outer ring, then the holes. The last corner is not repeated.
struct SectionFace {
  std::vector<std::vector<Vec3>> rings;
};

// A plane and its axes, which are of unit length and perpendicular: u points to the right of the drawing and v points
// up. Only the range from `from` to `to` along u is cut.
struct SectionPlane {
  Vec3 origin, u{1, 0, 0}, v{0, 1, 0};
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

// Returns where the plane passes through the faces, in the axes of the plane: the segments inside each face (even-odd
// rule), face by face, along the cut. Corners in the plane count as in front of it, so that a ring is crossed an even
// number of times. A face in the plane gives nothing. O(corners), and O(k log k) for a face that is crossed k times.
std::vector<FlatEdge> cut_faces(std::span<const SectionFace> faces, const SectionPlane& plane);

// Joins segments where their ends are at most `touch` apart. Each end is joined with the nearest free one (ties: the
// earlier). The result is lists of corners; the first corner is repeated at the end of a closed list. Segments shorter
// than `touch` are left out. O(n log n) where the ends are farther apart than `touch`.
std::vector<std::vector<FlatPoint>> join_stretches(std::span<const FlatEdge> edges, double touch);

}  // namespace ilot
