// SPDX-License-Identifier: Apache-2.0
// Assigns points to the nodes of a COPC file. It works in memory only.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels/neighbours/morton.h"

namespace ilot {

constexpr std::size_t kInfoSize = 160, kEntrySize = 32;  // bytes of the info record and of an entry of the hierarchy
constexpr int kCopcGridBits = 7;               // a node that has children keeps one point for each cell of 128^3
constexpr std::uint64_t kCopcLeaf = 1u << 16;  // nodes with at most this number of points below them are not split

// A point: the Morton code of its cell, among 2^21 cells along each edge of the root cube, and its row in the input.
struct CopcPoint {
  std::uint64_t code = 0;
  std::uint32_t row = 0;
};

struct CopcNode {
  int level = 0;
  Cell3 cell;                        // among 2^level cells along each edge of the root cube
  std::uint64_t first = 0, end = 0;  // its points
};

// Reorders the points so that the points of each node are consecutive and ascending by row. Returns the nodes: the root
// first, then level by level. In each cell of its grid a node keeps the point nearest to the centre (ties: the smaller
// code, then the smaller row) and passes the others down. A cube of level 21 keeps everything. Every node contains a
// point, except the root when there are no points. Rows must differ. O(n log n) time; the only extra memory is for the
// points of one node.
std::vector<CopcNode> build_copc_octree(std::vector<CopcPoint>& points);

}  // namespace ilot
