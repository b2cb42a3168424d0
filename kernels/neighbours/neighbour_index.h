// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// A hierarchy of bounding boxes over points that are already in Morton order: eight consecutive points are a leaf (one
// vector register), eight consecutive leaves a node, and so on. No pointers, no reordering: 3.4 bytes a point.
struct NeighbourIndex {
  Points points;                          // not owned; must outlive the index
  std::vector<std::vector<float>> boxes;  // per level, nodes of 8 child boxes: min x8 y8 z8, max x8 y8 z8
};

// O(n). Any order of points gives right answers; Morton order gives fast ones.
NeighbourIndex build_neighbour_index(Points points);

}  // namespace ilot
