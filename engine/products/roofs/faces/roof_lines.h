// SPDX-License-Identifier: Apache-2.0
// The lines along which roof faces can meet: ridges, hips and valleys where two planes cross, and steps.
#pragma once
#include <vector>

#include "engine/products/roofs/faces/roof_planes.h"
#include "kernels/geometry/flat.h"

namespace ilot {

// Finds lines that may divide the outline, in metres from the site's anchor. Each line runs along the common border of
// its faces and on to the next line or the outline, at most 15 m farther. A border is seen where a Delaunay
// triangulation of the labelled points, from above, joins points of two planes. Where the planes cross within reach of
// that place, the line is their line of intersection. Otherwise it is a step. A step runs in a direction of the outline
// or of a plane where one fits and separates the upper points from the lower ones (step_offset.h). Steps within 10 cm
// of a wall's line or of a longer step are moved onto it. Faces below 10 m2 whose points fill a rectangle also give the
// sides of that rectangle, because their borders are too short to be seen (face_rectangles.h). O(n log n).
std::vector<FlatEdge> roof_lines(const RoofSite& site, const RoofPlanes& planes);

}  // namespace ilot
