// SPDX-License-Identifier: Apache-2.0
// The section of the roofs: how good they are, which to look at, and why some have no LoD2.2.
#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/deliverables/report/scene_buildings.h"

namespace ilot {

// Buildings that are drawn over their points, by row.
struct DrawnBuildings {
  std::vector<std::size_t> worst, most_faces, random;
  std::set<std::uint32_t> units(const std::vector<BuildingRow>& rows) const;
};
DrawnBuildings choose_drawn(const std::vector<BuildingRow>& rows);

// The order of doubt: bad before check before good, then the larger share of points off the roof.
// Buildings without points are left out: nothing there was measured that could be doubted.
std::vector<std::size_t> most_doubtful(const std::vector<BuildingRow>& rows, std::size_t most);

std::string roofs_section(const std::vector<BuildingRow>& rows, const DrawnBuildings& drawn,
                          const std::map<std::uint32_t, std::vector<Vec3>>& points, const SceneFrame& frame);

}  // namespace ilot
