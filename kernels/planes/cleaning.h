// SPDX-License-Identifier: Apache-2.0
// Cleaning a cloud before planes are sought [Marchand 2018, II.1]. Each filter says per point whether it stays: 1, or 0
// = dropped.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/planes/region_growing.h"

namespace ilot {

using Kept = std::vector<std::uint8_t>;

// Drops points whose neighbourhood is much sparser than the mean: the distance to the k-th neighbour (reach2 as knn()
// gives it, -1 = fewer than k) is more than `factor` times the mean of that distance, in whole units, over all points
// that have k. Integer sums: the order of points does not matter. O(n).
Kept density_filter(std::span<const std::int64_t> reach2, double factor = 4);

// Drops clusters [Boltcheva et al. 2019, 3.1] of fewer than min_points; two points farther apart than max_gap are in
// different clusters unless others lie between. O(n log n).
Kept distance_split(Points points, std::int64_t max_gap, std::uint32_t min_points);

// Keeps the slab from `behind` to `before` the plane, signed distances along its normal, both inclusive. O(n).
Kept slab_split(Points points, const Plane& plane, double behind, double before);

// Without stations: drops points that are isolated among their own neighbours: the distance to their k-th neighbour is
// more than `factor` times the lower quartile of that distance over those neighbours. Surfaces keep their points at any
// density; of points that hang between surfaces those near one are found, while a sheet of them behind an edge looks
// like a sparse surface: with stations, mixed_pixel_filter sees them. O(n k).
Kept isolation_filter(const NeighbourLists& neighbours, std::span<const std::int64_t> reach2, double factor = 2.5);

struct MixedPixelParams {
  double jump = 0;            // units; ranges that differ by more belong to different surfaces
  double max_angle = 0.01;    // radians; rays farther apart do not compare
  std::uint32_t least = 2;    // rays around that pass nearer, and that pass farther, at least
  std::uint32_t support = 2;  // rays around that meet the same range (within jump) save a point if there are more
};

// With the station known: drops points that hang between two surfaces along their ray, where a beam met both. A point
// is one when of the eight rays around it at least two end nearer by more than `jump`, at least two farther, at most
// two at its own range, and the nine points do not lie on one plane that tells their ranges within `jump` (a slanting
// surface). Directions are rounded to 2^-20 and compared by
// exact nearest neighbours. `station` in the frame of the points, all of one station. A point at the station itself
// stays. O(n log n).
Kept mixed_pixel_filter(Points points, Vec3 station, const MixedPixelParams& params);

}  // namespace ilot
