// SPDX-License-Identifier: Apache-2.0
// Finds how far something else than the wall goes on beyond a side of an opening, between the lines of its other sides.
#pragma once
#include "engine/products/facades/rays/ray_samples.h"
#include "engine/products/facades/sides/located_edge.h"

namespace ilot {

// Metres beyond a side of a box within which the opening may go on; 0 where the wall begins at the side. It may go on
// behind a panel, the board below a shop window or a blind that is down: flat points, as wide as the opening, that are
// not in one plane with what is beside them by three standard deviations, where they or what is beside them are not in
// the plane of the wall (`wall_depth`) either. And it may go on where nothing is seen before the wall begins. O(points
// around).
double panel_beyond(const RaySamples& samples, const Box2& box, double wall_depth, Side side);

}  // namespace ilot
