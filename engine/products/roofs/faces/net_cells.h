// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/roofs/faces/line_net.h"
#include "engine/products/roofs/faces/partition.h"

namespace ilot {

// Returns the cells of a net that lie inside its border: those that a path from far away reaches over an odd number of
// border edges. Regions are numbered by their least vertices; regions with the same least vertex are numbered
// counter-clockwise from the direction of +x. Edges with one cell on both sides are left out: dead ends, and bridges
// between two parts. O(n log n + components x n).
Partition cells_inside(const LineNet& net);

}  // namespace ilot
