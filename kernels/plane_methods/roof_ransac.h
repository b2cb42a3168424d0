// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/planes/plane_segments.h"
#include "kernels/planes/region_growing.h"

namespace ilot {

struct RoofRansacParams {
  double epsilon = 0;                     // units; greatest distance of a point from its plane [1/12 m]
  std::int64_t stray_gap = 1;             // units; points farther than this from the rest of a plane are strays
  std::uint32_t inner = 64, outer = 128;  // a sample comes from the `outer` nearest points without the `inner` nearest
  std::uint32_t min_points = 100;         // fewest points of a plane
  std::uint32_t min_remaining = 128;      // the search ends when fewer points are left
  std::uint32_t draws = 64;               // the search ends after so many draws in a row without a plane of min_points
  std::uint64_t key = 0;
};

// Finds roof planes [Boltcheva et al. 2019, 3.2.2]. A draw is a random point and three points from the ring between its
// 64 and its 128 nearest. They are far enough apart to be robust against noise and near enough to be on one face. The
// best of 64 draws is refined by least squares [Lorraine thesis, 2.2.2], and its strays are available again. The
// document triangulates the inliers in the plane, drops long edges and floods from the largest part. A Delaunay
// triangulation contains a minimum spanning tree, so its parts are those of all pairs nearer than the limit. These are
// found directly. The search ends with fewer than 128 points, or when 64 draws give no plane of 100 points.
// Last, islands inside another face go to the plane of the majority of their neighbours (the document: 12) if they are
// within epsilon of it. Planes that are left with fewer than min_points lose their points. Normals are not used.
// O(draws x n) per plane.
PlaneSegments roof_ransac(Points points, const NeighbourLists& neighbours, const RoofRansacParams& params);

}  // namespace ilot
