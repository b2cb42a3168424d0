// SPDX-License-Identifier: Apache-2.0
// Measures how well boundary points agree with true edges. [Lorraine thesis, 3.4.3]
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/compare/truth.h"
#include "kernels/geometry/flat.h"

namespace ilot {

struct BoundaryCounts {
  std::uint64_t truth = 0;   // Bm: points whose Voronoi cell in the plane meets the true edge
  std::uint64_t found = 0;   // Ba: points marked as boundary
  std::uint64_t common = 0;  // in both

  // E = |Bm xor Ba| / |Bm and Ba|; infinite when nothing is common and one set is not empty, 0 when both are empty.
  double error() const;
  void add(const BoundaryCounts& other);
};

// The points by which the boundary of one true plane is judged.
struct BoundaryPoints {
  std::vector<Vec3> own;                 // points of the true plane, of the plane found for it, or of both
  std::vector<std::uint8_t> true_point;  // flag: belongs to the true plane; the Voronoi diagram is of these points
  std::vector<std::uint8_t> marked;      // flag: belongs to the found plane and is marked as boundary
};

// The true edge is the outline of the union of the plane's polygons, where corners within 1 mm of each other are one.
// So edges between neighbouring polygons of one plane do not count. Points are projected onto the true plane.
BoundaryCounts boundary_counts(const TruePlane& plane, const BoundaryPoints& points, double metres_per_unit = 1);

// The outline as above, in the frame plane_frame(plane.plane.n, first corner). It is empty without polygons.
std::vector<FlatEdge> true_edges(const TruePlane& plane, double metres_per_unit = 1);

// The mean distance of a closed ring's line from the nearest edge, sampled every `step` (at least once per edge); 0
// without edges. O(samples edges).
double mean_ring_distance(std::span<const FlatPoint> ring, std::span<const FlatEdge> edges, double step);

}  // namespace ilot
