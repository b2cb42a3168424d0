// SPDX-License-Identifier: Apache-2.0
// Euclidean clusters over all blocks [Boltcheva et al. 2019, 3.1]: points that are connected in plan are one cluster,
// even across blocks.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/pass/context.h"
#include "engine/store/store.h"
#include "kernels/geometry/box3.h"

namespace ilot {

struct ClusterParams {
  PointRole role{};         // points of this role (column "role") are clustered
  std::int64_t radius = 1;  // lattice units; points at most this far from each other in plan are in one cluster
};

struct CloudCluster {
  Index3 first;  // its first point in global order
  std::uint64_t points = 0;
  IndexBox box;  // box of its points
};

// Writes the column "cluster" (u32: 0 = none, else 1 + index into the result) of every block. Clusters are ordered by
// their first points. The result depends on the points alone. Each block is read with a halo of the radius.
std::vector<CloudCluster> clusters_pass(const Store& store, const ClusterParams& params, const PassContext& context);

}  // namespace ilot
