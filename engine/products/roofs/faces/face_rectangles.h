// SPDX-License-Identifier: Apache-2.0
// Rectangles around small roof faces, whose borders are too short to be seen as lines.
#pragma once
#include <span>
#include <vector>

#include "engine/products/roofs/faces/roof_planes.h"
#include "kernels/geometry/flat.h"

namespace ilot {

// The sides of a rectangle around the points of every plane that has few of them (10 m2), in one of the directions
// (unit length, the likeliest first): the one of least area, where the points fill it. A side lies between the plane's
// points and those of others beyond it; where they leave a strip bare, beside the upper of the two, as with any step
// (step_offset.h). Sides that nearly lie on a line given are drawn on it. O(n log n).
std::vector<FlatEdge> face_rectangles(const RoofSite& site, const RoofPlanes& planes,
                                      std::span<const FlatPoint> directions, std::span<const FlatEdge> lines);

}  // namespace ilot
