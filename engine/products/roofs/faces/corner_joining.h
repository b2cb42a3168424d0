// SPDX-License-Identifier: Apache-2.0
// Draws the borders of roof faces with few corners.
#pragma once
#include <span>

#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

// Joins the ends of edges shorter than `reach` metres into one corner, the shortest edge first, as long as no other
// edge is crossed. Corners of the outline stay where they are, and other vertices on the outline stay on it. Two
// vertices inside of the outline meet where the heights of the faces around them agree best, within `reach`. A face
// that has no width left disappears; its number stays unused. `planes`: of the faces, by region - 1. O(joined vertices
// x edges).
void join_corners(Partition& faces, const SitePolygon& outline, std::span<const RoofPlane> planes, double reach);

}  // namespace ilot
