// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/area_key.h"

#include <nlohmann/json.hpp>

#include "engine/scale/plan_json.h"
#include "engine/scale/plan_products.h"
#include "engine/settings/config.h"

namespace ilot {

std::string area_key(const Plan& plan, const PlanArea& area, const std::string& sites) {
  nlohmann::ordered_json decides = task_json(plan);
  decides["own"] = box_json(area.own);
  decides["read"] = box_json(area.read);
  decides["sites"] = sites;
  decides["by_shape"] = plan.roofs.by_shape;
  decides["inputs"] = nlohmann::ordered_json::array();
  for (const std::uint32_t i : area.inputs) decides["inputs"].push_back(plan.inputs[i].sha256);
  if (carries_stations(plan, area))
    for (const std::uint32_t i : area.inputs) decides["stations"].push_back(row_stations_json(plan.inputs[i].stations));
  return plan_hash(decides.dump());
}

}  // namespace ilot
