// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// A hierarchy of bounding boxes over points that are already in Morton order. Eight consecutive points are a leaf (one
// vector register), eight consecutive leaves are a node, and so on. There are no pointers and the points are not
// reordered. It needs 3.4 bytes per point.
struct NeighbourIndex {
  Points points;                          // not owned; must outlive the index
  std::vector<std::vector<float>> boxes;  // per level, nodes of 8 child boxes: min x8 y8 z8, max x8 y8 z8
};

// O(n). The results of searches are right for any order of points, and the searches are fast for Morton order.
NeighbourIndex build_neighbour_index(Points points);

}  // namespace ilot
