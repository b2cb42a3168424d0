// SPDX-License-Identifier: Apache-2.0
// Pictures of one building as SVG.
#pragma once
#include <span>
#include <string>

#include "engine/model/building.h"

namespace ilot {

// Paths of the roof faces seen from above, shaded by where they look, <path> elements alone: x to the east from
// origin.x, y to the south from origin.y, units of the CRS. A flat outline becomes one path. O(corners).
std::string plan_paths(const Building& building, Vec3 origin);

// The solid from the south-west, 30 degrees above the horizon, over points of its cloud (coordinates of the CRS): an
// <svg> element of that size in pixels. Faces are painted from back to front. O(corners + points).
std::string oblique_drawing(const Building& building, std::span<const Vec3> points, int width, int height);

}  // namespace ilot
