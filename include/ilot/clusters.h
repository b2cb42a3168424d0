// SPDX-License-Identifier: Apache-2.0
// Points in memory, parted where there are gaps.
//
//   const ilot::Clusters groups = ilot::euclidean_clusters({x, y, z}, 0.5);
//   std::printf("%u groups\n", groups.count);
//
// Owns nothing, keeps nothing; several threads may call it at once.
#pragma once
#include <cstdint>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

struct Clusters {
  std::vector<std::uint32_t> id;  // per point: 0 to count-1, numbered by first appearance
  std::uint32_t count = 0;
};

// Points at most `radius` (units of the coordinates) apart are in one cluster, and so are chains of them (Boltcheva et
// al. 2019, 3.1). `step` as in geometry.h, 0 = lattice_step(points); the radius is rounded to whole steps, and gaps
// within two steps of it may be closed or not. The order of points does not matter but for the numbers. O(n log n).
// Error (usage) for a radius below a step or below 1/500,000 of the longest side of the points' box.
Clusters euclidean_clusters(const PointArrays& points, double radius, double step = 0);

}  // namespace ilot
