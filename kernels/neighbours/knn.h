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

// The k nearest points of each query, which is the index of a point of `index`. neighbours holds k entries a query in
// ascending order of index, filled up with kNoNeighbour where fewer lie within max_d2. reach2 holds the squared
// distance of the k-th, or -1 where fewer than k were found. Exact: distances are compared as integers, ties at the
// k-th go to the smaller index (in Morton-sorted points: the smaller coordinates, then the smaller record). Queries in
// index order are several times faster than in random order. About O(log n + k) a query on surfaces.
void knn(const NeighbourIndex& index, std::span<const std::uint32_t> queries, const KnnParams& params,
         std::span<std::uint32_t> neighbours, std::span<std::int64_t> reach2);

}  // namespace ilot
