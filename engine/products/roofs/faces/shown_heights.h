// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/products/roofs/faces/roof_planes.h"
#include "kernels/planes/region_growing.h"
#include "kernels/planes/run_neighbours.h"

namespace ilot {

// Widens `lowest` and `highest` of each plane to points of other planes that show it, too: those within epsilon of it
// that are reached from its own points over neighbours that are. Where faces meet at small angles, as at the tip of a
// tent, each point has one plane alone, and the others would seem to end below. O(n) in points and their neighbours for
// each plane, near borders.
void widen_heights(std::span<const Vec3> points, const NeighbourLists& neighbours, const RunNeighbours& runs,
                   RoofPlanes& planes);

}  // namespace ilot
