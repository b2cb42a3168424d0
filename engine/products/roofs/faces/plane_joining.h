// SPDX-License-Identifier: Apache-2.0
// Joins planes that differ by less than what a roof plan shows.
#pragma once
#include "engine/products/roofs/faces/roof_planes.h"
#include "kernels/core/types.h"
#include "kernels/planes/plane_fit.h"

namespace ilot {

// A plane in whole millimetres from `corner` (metres from the site's anchor) as a roof plane without points.
RoofPlane roof_plane(const Plane& plane, Vec3 corner);

// Joins planes with points near each other in plan when one plane fits the points of both: nine tenths of the points of
// each plane that was given lie within `detail` metres of it. For pairs in which one plane slopes by more than 5
// degrees and both are wider than a metre, half of `detail` holds, because the eye sees a crease between slopes. So
// falls for drainage, parapets and sags of flat roofs are one face, and a vault keeps facets. The pair with the least
// residuals is joined first. planes.epsilon becomes `detail` at least. `points` are those of the site in whole
// millimetres from `corner`, in their order. O(planes x points) at worst; pairs that are clearly apart cost O(1).
void join_explained(Points points, Vec3 corner, double detail, RoofPlanes& planes);

}  // namespace ilot
