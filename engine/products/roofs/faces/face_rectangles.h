// SPDX-License-Identifier: Apache-2.0
// Rectangles around small roof faces, whose borders are too short to be seen as lines.
#pragma once
#include <span>
#include <vector>

#include "engine/products/roofs/faces/roof_planes.h"
#include "kernels/geometry/flat.h"

namespace ilot {

// Returns the sides of a rectangle around the points of every plane that has few points (10 m2). Among the given
// directions (unit length, the likeliest first) it takes the rectangle of least area, if the points fill it. A side
// lies between the plane's points and the points of others beyond it. Where these leave a strip without points, the
// side lies beside the upper of the two, as with any step (step_offset.h). Sides that nearly lie on one of the given
// lines are moved onto it. O(n log n).
std::vector<FlatEdge> face_rectangles(const RoofSite& site, const RoofPlanes& planes,
                                      std::span<const FlatPoint> directions, std::span<const FlatEdge> lines);

}  // namespace ilot
