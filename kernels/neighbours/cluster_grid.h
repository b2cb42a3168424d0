// SPDX-License-Identifier: Apache-2.0
// Clusters of many subsets of the same points: what depends on the points alone is computed once.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/neighbours/clusters.h"
#include "kernels/neighbours/reach.h"

namespace ilot {

// Points in bins so small that any two points of a bin are within the radius, and for each bin the bins after it, in
// the order of their keys, with points that can be within the radius; so each pair is listed once. Bins are numbered by
// their first point: points in Morton order have near numbers where they are near.
struct ClusterGrid {
  struct Near {
    std::size_t begin = 0;  // in `near`: bins that touch this one, then those two bins away
    std::uint32_t touching = 0, all = 0;
  };
  std::int64_t radius = 0;
  std::vector<std::uint32_t> bin;   // of each point
  std::vector<Near> near_of;        // of each bin
  std::vector<std::uint32_t> near;  // numbers of bins

  bool empty() const { return bin.empty(); }
};

// Builds the grid of all points, which have integer coordinates. It is empty where there are none, where the radius is
// below 2^-20 of the extent of the points, and where bins have so many bins near them, and so few points, that more
// than eight would be listed for each point. O(n log n).
ClusterGrid build_cluster_grid(Points points, std::int64_t radius);

// Returns the grid of some points of another, from the bin that each has in the other. O(bins of the other).
ClusterGrid subset_grid(const ClusterGrid& grid, std::span<const std::uint32_t> bins);

// The memory that grid_clusters() works in. It must be passed on unchanged, to calls with any grid.
struct ClusterScratch {
  std::vector<std::uint32_t> slot;                             // of each bin: its number among the bins in use
  std::vector<std::uint32_t> bins, begin, of, parent, number;  // of each bin in use; `of`: of each point, its slot
  std::vector<std::uint32_t> met;                              // slots near a bin
  std::vector<IntPoint> points;                                // bin by bin
};

// Returns the same as euclidean_clusters(points, indices, grid.radius) for the points of the grid. O(n) for points that
// are spread evenly.
Clusters grid_clusters(const ClusterGrid& grid, Points points, std::span<const std::uint32_t> indices,
                       ClusterScratch& scratch);

}  // namespace ilot
