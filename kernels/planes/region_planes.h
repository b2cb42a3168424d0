// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/planes/plane_segments.h"
#include "kernels/planes/region_growing.h"

namespace ilot {

// The estimate of the plane of a region.
enum class PlaneEstimate {
  kMeanNormal,    // [Boltcheva et al. 2019, 3.2.1]: mean of normals over wide neighbourhoods, through the centroid
  kLeastSquares,  // refined as in [Lorraine thesis, 2.2.2]
  kBest,          // the one of the two with more points within epsilon, least squares where they are equal
};

struct RegionPlaneParams {
  double epsilon = 0;             // units; greatest distance of a labelled point from its final plane
  std::uint32_t min_points = 3;   // fewest points of a plane
  std::int64_t connectivity = 1;  // units; the remaining points of a region split where they are farther apart
  PlaneEstimate estimate = PlaneEstimate::kBest;
};

// Finds the planes of grown regions. A region that bends, or that grew over a smooth edge, is not one plane. The part
// of it within epsilon of its best plane is taken. The search for this plane starts from all points of the region, from
// the neighbourhood of its seed and from those of eight more points spread over it, and takes the result with most
// points. The remaining points are tried again, one connected component after the other, until no component of
// min_points is left. For the mean normal of the document, normals are estimated again over 20% of the region around a
// point, for 64 points evenly spread over it. Regions above 10,000 points use least squares. Labels are in the order of
// regions, then of parts. O(n x parts); mean normals O(64 n).
PlaneSegments planes_of_regions(Points points, const Regions& regions, const RegionPlaneParams& params);

}  // namespace ilot
