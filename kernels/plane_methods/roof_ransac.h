// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/planes/plane_segments.h"
#include "kernels/planes/region_growing.h"

namespace ilot {

struct RoofRansacParams {
  double epsilon = 0;                     // units; greatest distance of a point from its plane [1/12 m]
  std::int64_t stray_gap = 1;             // units; points farther than this from the rest of a plane are strays
  std::uint32_t inner = 64, outer = 128;  // a sample lies among the outer nearest points, not among the inner
  std::uint32_t min_points = 100;         // of a plane
  std::uint32_t min_remaining = 128;      // the search ends below
  std::uint32_t draws = 64;               // in a row without a plane of min_points end the search
  std::uint64_t key = 0;
};

// Roof planes [Boltcheva et al. 2019, 3.2.2]: a point at random and three points from the ring between its 64 and its
// 128 nearest, far enough not to see the noise and near enough to see one face. The best of 64 draws is refined by
// least squares [Lorraine thesis, 2.2.2] and its strays go back: the document triangulates the inliers in the plane,
// drops long edges and floods from the largest part; since a Delaunay triangulation contains a minimal spanning tree,
// its parts are those of all pairs nearer than the limit, which are found directly. Ends with fewer than 128 points, or
// when 64 draws give no plane of 100 points. Last, islands inside another face go to the majority of their neighbours
// (the document: 12) if they lie within epsilon of its plane; planes left with fewer than min_points lose them. Normals
// are not used. O(draws x n) a plane.
PlaneSegments roof_ransac(Points points, const NeighbourLists& neighbours, const RoofRansacParams& params);

}  // namespace ilot
