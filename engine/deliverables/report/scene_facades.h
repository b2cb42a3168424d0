// SPDX-License-Identifier: Apache-2.0
// Facades, street objects and planes as the report's scripts read them.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/deliverables/report/result_folder.h"
#include "engine/model/facade.h"
#include "engine/model/largest_outlines.h"
#include "engine/model/segment.h"
#include "engine/model/street.h"

namespace ilot {

// One facade: its frame in the scene (metres), and its elements in that frame, in whole centimetres.
nlohmann::ordered_json scene_facade(const Facade& facade, const SceneFrame& frame);

// The objects, blocks and gaps of a street, in whole centimetres of the scene.
nlohmann::ordered_json scene_street(const StreetPlan& plan, const SceneFrame& frame);

// The table of planes as columns, and the outlines of some of them, packed: plane, parts, rings, corners.
nlohmann::ordered_json scene_planes(const std::vector<Segment>& planes, const SceneFrame& frame);
std::string packed_outlines(const LargestOutlines& outlines, const SceneFrame& frame);

}  // namespace ilot
