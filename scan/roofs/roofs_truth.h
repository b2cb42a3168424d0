// SPDX-License-Identifier: Apache-2.0
// What the truth files of towns of roofs say about planes and buildings.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/deliverables/solids/city_json.h"
#include "scan/roofs/roof_town.h"
#include "scan/truth_writer.h"

namespace ilot::scan {

// Returns all planes, sorted by id: that of the ground (kTownGround), then those of the town. `points` are by id.
std::vector<TruePlane> planes_of_town(const RoofTown& town, const std::vector<std::uint64_t>& points);

TrueBuilding truth_of_building(const RoofBuilding& building, std::uint32_t id);

// Returns the solid of a building in world coordinates.
Building model_of(const RoofBuilding& building, std::uint32_t id);

}  // namespace ilot::scan
