// SPDX-License-Identifier: Apache-2.0
// Parts of a building that both layers and pictures show.
#pragma once
#include <optional>
#include <vector>

#include "engine/replay/building_replay.h"

namespace ilot {

// A point that was used; `number` is its index among the points from which the model was made.
struct SeenPoint {
  Vec3 at;  // metres from the site's anchor
  PointRole role{};
  PointMembership membership{};
  std::optional<std::size_t> number;
};

// Returns the height of the site's anchor above 0 of the CRS, in metres.
double floor_of(const BuildingReplay& building);

// Returns the points around the building and all points of its model, in global order.
std::vector<SeenPoint> seen_points(const BuildingReplay& building);

// Returns the convex hull of the points of each plane, seen from above; empty when they are on a line.
std::vector<SitePolygon> plane_hulls(const SiteSteps& steps);

const char* name_of(PointRole role);
const char* name_of(PointMembership membership);

}  // namespace ilot
