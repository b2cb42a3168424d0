// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/roofs/faces/line_net.h"
#include "engine/products/roofs/faces/partition.h"

namespace ilot {

// The cells of a net that lie inside its border: those that a way from far away reaches over an odd number of border
// edges. Regions are numbered by their least vertices, those that share it counter-clockwise from the direction of +x.
// Edges with one cell on both sides are left out: ends that lead nowhere, and what bridges two parts.
// O(n log n + components x n).
Partition cells_inside(LineNet net);

}  // namespace ilot
