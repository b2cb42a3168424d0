// SPDX-License-Identifier: Apache-2.0
// Pictures of one building as SVG.
#pragma once
#include <span>
#include <string>

#include "engine/model/building.h"

namespace ilot {

// Returns <path> elements only: the roof faces seen from above, shaded by the direction that they face. x runs to the
// east from origin.x, y to the south from origin.y, both in units of the CRS. A flat outline becomes one path.
// O(corners).
std::string plan_paths(const Building& building, Vec3 origin);

// Returns an <svg> element of the given size in pixels. It shows the solid from the south-west, 30 degrees above the
// horizon, over points of its cloud (coordinates of the CRS). Faces are painted from back to front. O(corners +
// points).
std::string oblique_drawing(const Building& building, std::span<const Vec3> points, int width, int height);

}  // namespace ilot
