// SPDX-License-Identifier: Apache-2.0
// Gives roof planes the regular positions in which roofs are built, where their points do not speak against it.
#pragma once
#include <span>

#include "engine/products/roofs/faces/roof_planes.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "kernels/core/types.h"

namespace ilot {

// Each plane, those with the most points first, turns about the centre of its points to the position of the fewest free
// numbers: level, or along a main direction and as steep as an earlier plane; else along a main direction; else it
// stays. Main directions are those of the outline's sides and of earlier planes, and across these. Planes of one slope
// and direction take one height. So the slopes of a gable are symmetric, its ridge and its eaves are level and parallel
// to the walls. A position is allowed while it moves the plane at its points by at most half of their own distance from
// it (root mean square), or by two standard errors of a plane through so few points; the nearest allowed one is taken.
// The relations are those of [Verdie et al. 2015], the bounds come from the points in place of fixed angles.
// `points` are those of the site, metres from its anchor. O(points + planes^2).
void make_regular(const SitePolygon& outline, std::span<const Vec3> points, RoofPlanes& planes);

}  // namespace ilot
