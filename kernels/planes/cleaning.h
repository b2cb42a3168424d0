// SPDX-License-Identifier: Apache-2.0
// Cleaning of a cloud before planes are sought [Marchand 2018, II.1]. Each filter returns for each point 1 when it is
// kept and 0 when it is dropped.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/planes/region_growing.h"

namespace ilot {

using Kept = std::vector<std::uint8_t>;

// Drops points whose neighbourhood is much sparser than the mean. A point is dropped when the distance to its k-th
// neighbour is more than `factor` times the mean of that distance. The mean is in whole units, over all points with k
// neighbours. reach2 is as knn() gives it, -1 = fewer than k. Sums are integers, so the order of points does not
// matter. O(n).
Kept density_filter(std::span<const std::int64_t> reach2, double factor = 4);

// Drops clusters [Boltcheva et al. 2019, 3.1] of fewer than min_points. Two points farther apart than max_gap are in
// different clusters unless points between them join them. O(n log n).
Kept distance_split(Points points, std::int64_t max_gap, std::uint32_t min_points);

// Keeps the slab from `behind` to `before` the plane. Both are signed distances along its normal, inclusive. O(n).
Kept slab_split(Points points, const Plane& plane, double behind, double before);

// Drops points that are isolated among their own neighbours; no station is needed. The distance to the k-th neighbour
// of such a point is more than `factor` times the lower quartile of that distance over its neighbours. Surfaces keep
// their points at any density. Points between surfaces are found near a surface, but a sheet of them behind an edge
// looks like a sparse surface. With stations, mixed_pixel_filter finds such a sheet. O(n k).
Kept isolation_filter(const NeighbourLists& neighbours, std::span<const std::int64_t> reach2, double factor = 2.5);

struct MixedPixelParams {
  double jump = 0;            // units; ranges that differ by more belong to different surfaces
  double max_angle = 0.01;    // radians; rays farther apart are not compared
  std::uint32_t least = 2;    // fewest rays around a point that end nearer, and fewest that end farther
  std::uint32_t support = 2;  // a point stays when more rays around it than this have the same range (within jump)
};

// Drops mixed pixels when the station is known. These are points between two surfaces along their ray, where one beam
// met both. A point is a mixed pixel under these conditions on the eight rays around it: at least two end nearer by
// more than `jump`, at least two end farther, and at most two end at its own range. In addition the nine points must
// not be on one plane that predicts their ranges within `jump` (a slanted surface). Directions are rounded to 2^-20 and
// compared by exact nearest neighbours. `station` is in the frame of the points, and all points are of this station. A
// point at the station itself stays. O(n log n).
Kept mixed_pixel_filter(Points points, Vec3 station, const MixedPixelParams& params);

}  // namespace ilot
