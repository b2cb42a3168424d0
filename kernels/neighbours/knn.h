// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/neighbours/neighbour_index.h"

namespace ilot {

constexpr std::uint32_t kNoNeighbour = 0xffffffffu;
constexpr int kMaxNeighbours = 64;
constexpr std::int64_t kMaxSquaredReach = std::int64_t{1} << 46;

struct KnnParams {
  int k = 16;                              // 1 to kMaxNeighbours; the query point itself counts as the first
  std::int64_t max_d2 = kMaxSquaredReach;  // squared units, inclusive, at most kMaxSquaredReach
};

// Finds the k nearest points of each query, which is the index of a point of `index`. `neighbours` has k entries per
// query in ascending order of index, filled up with kNoNeighbour where fewer points are within max_d2. `reach2` has the
// squared distance of the k-th point, or -1 where fewer than k were found. The result is exact: distances are compared
// as integers, and ties at the k-th point go to the smaller index (in Morton-sorted points the smaller coordinates,
// then the smaller record). Queries in index order are several times faster than in random order. A query takes about
// O(log n + k) on surfaces. One query, of point 17:
//
//   const NeighbourIndex index = build_neighbour_index(points);
//   const std::uint32_t query = 17;
//   std::array<std::uint32_t, 8> near;  // 17 is one of them, at distance 0
//   std::int64_t reach2 = 0;            // of the farthest
//   knn(index, {&query, 1}, {.k = 8}, near, {&reach2, 1});
void knn(const NeighbourIndex& index, std::span<const std::uint32_t> queries, const KnnParams& params,
         std::span<std::uint32_t> neighbours, std::span<std::int64_t> reach2);

}  // namespace ilot
