// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/neighbours/neighbour_index.h"

namespace ilot {

// The answers of one query lie in index[begin[q]] to index[begin[q + 1]].
struct RadiusNeighbours {
  std::vector<std::uint64_t> begin;  // one more than there are queries
  std::vector<std::uint32_t> index;
};

// All points within a squared distance of each query (closed, 0 to kMaxSquaredReach of knn.h), in ascending order of
// index, the query itself included. A query is the index of a point of `index`. Exact: distances are compared as
// integers. Queries in index order are several times faster than in random order. About O(log n + answers) a query.
RadiusNeighbours radius_search(const NeighbourIndex& index, std::span<const std::uint32_t> queries,
                               std::int64_t radius2);

}  // namespace ilot
