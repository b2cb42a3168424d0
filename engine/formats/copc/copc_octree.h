// SPDX-License-Identifier: Apache-2.0
// Which point goes to which node of a COPC file. Memory only.
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/neighbours/morton.h"

namespace ilot {

constexpr int kCopcGridBits = 7;               // a node that has children keeps a point per cell of 128^3
constexpr std::uint64_t kCopcLeaf = 1u << 16;  // nodes with at most so many points below them are not split

// A point: the Morton code of its cell among the 2^21 along each edge of the root cube, and its row in the input.
struct CopcPoint {
  std::uint64_t code = 0;
  std::uint32_t row = 0;
};

struct CopcNode {
  int level = 0;
  Cell3 cell;                        // of the 2^level along each edge of the root cube
  std::uint64_t first = 0, end = 0;  // its points
};

// Reorders the points so that each node's are consecutive, ascending by row, and returns the nodes: the root first,
// then level by level. A node keeps, of each cell of its grid, the point nearest to the centre (ties: the smaller code,
// then the smaller row) and hands the rest down; a cube of level 21 keeps everything. Every node holds a point, but for
// the root of no points. Rows must differ. O(n log n) time, no memory but the points of one node.
std::vector<CopcNode> build_copc_octree(std::vector<CopcPoint>& points);

}  // namespace ilot
