// SPDX-License-Identifier: Apache-2.0
// Euclidean clusters over all blocks [Boltcheva et al. 2019, 3.1]: what hangs together in plan is one, wherever blocks
// end.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/pass/context.h"
#include "engine/store/store.h"
#include "kernels/geometry/box3.h"

namespace ilot {

struct ClusterParams {
  PointRole role{};         // points of this role (column "role") are clustered
  std::int64_t radius = 1;  // lattice units; points so near to each other in plan (closed) are in one cluster
};

struct CloudCluster {
  Index3 first;  // its first point in global order
  std::uint64_t points = 0;
  IndexBox box;  // of its points
};

// Writes the column "cluster" (u32: 0 = none, else 1 + index into the result) of every block; clusters are ordered by
// their first points. The answer is a property of the points alone. Each block is read with a halo of the radius.
std::vector<CloudCluster> clusters_pass(const Store& store, const ClusterParams& params, const PassContext& context);

}  // namespace ilot
