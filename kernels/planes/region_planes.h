// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/planes/plane_segments.h"
#include "kernels/planes/region_growing.h"

namespace ilot {

// How the plane of a region is estimated.
enum class PlaneEstimate {
  kMeanNormal,    // [Boltcheva et al. 2019, 3.2.1]: mean of normals over wide neighbourhoods, through the centroid
  kLeastSquares,  // refined as in [Lorraine thesis, 2.2.2]
  kBest,          // the one with more points within epsilon, least squares where they are equal
};

struct RegionPlaneParams {
  double epsilon = 0;             // units; greatest distance of a labelled point from its final plane
  std::uint32_t min_points = 3;   // of a plane
  std::int64_t connectivity = 1;  // units; leftovers of a region fall apart where points are farther apart
  PlaneEstimate estimate = PlaneEstimate::kBest;
};

// Planes of grown regions. A region that bends, or that leaked over a smooth edge, is no plane: the part of it within
// epsilon of its best plane is taken (started from all its points, from the neighbourhood of its seed and from eight
// more spread over it, whichever gives most), and what is left over is tried again, connected part by connected part,
// until no part of min_points remains. The mean normal of the document: normals are estimated anew over 20% of the
// region around a point, for 64 points evenly spread over it; regions above 10,000 points use least squares. Labels by
// region, then by part. O(n x parts); mean normals O(64 n).
PlaneSegments planes_of_regions(Points points, const Regions& regions, const RegionPlaneParams& params);

}  // namespace ilot
