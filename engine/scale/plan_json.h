// SPDX-License-Identifier: Apache-2.0
// Pieces of plan.json that other files need too.
#pragma once
#include <nlohmann/json.hpp>

#include "engine/scale/plan.h"

namespace ilot {

nlohmann::ordered_json box_json(const IndexBox& box);
nlohmann::ordered_json row_stations_json(const InputStations& stations);

// What all tasks of a plan have in common and what decides their results.
nlohmann::ordered_json task_json(const Plan& plan);

}  // namespace ilot
