// SPDX-License-Identifier: Apache-2.0
// What both layers and pictures show of a building.
#pragma once
#include <optional>
#include <vector>

#include "engine/replay/building_replay.h"

namespace ilot {

// A point that was looked at; `number` is its place among those that the model was made from.
struct SeenPoint {
  Vec3 at;  // metres from the site's anchor
  PointRole role{};
  PointMembership membership{};
  std::optional<std::size_t> number;
};

// Metres that the site's anchor lies above 0 of the CRS.
double floor_of(const BuildingReplay& building);

// Those around the building and all of its model, in global order.
std::vector<SeenPoint> seen_points(const BuildingReplay& building);

// The convex hull of each plane's points, seen from above; empty where these lie on a line.
std::vector<SitePolygon> plane_hulls(const SiteSteps& steps);

const char* name_of(PointRole role);
const char* name_of(PointMembership membership);

}  // namespace ilot
