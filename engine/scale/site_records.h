// SPDX-License-Identifier: Apache-2.0
// Sites and buildings as records: what a plan hands to a task, and what a task hands to the merge. Numbers keep all
// their bits.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>

#include "engine/products/roofs/site_modeller.h"
#include "engine/products/roofs/sites/site_plan.h"

namespace ilot {

// A site in a list of all sites of a run.
struct NumberedSite {
  std::uint64_t number = 0;  // in the list of all sites
  bool own = false;          // of the area; else a neighbour, whose outline matters
  bool outside = false;      // its outline lies wholly outside of the extent of all points
  bool sampled = false;      // one of those by which the common shift of footprints is measured
  PlannedSite site;
};

// A building that a task made of a site of its own, without the places of its points.
struct BuiltSite {
  std::uint64_t labelled = 0;  // points that have its label
  SiteResult result;
};

nlohmann::json record_of(const NumberedSite& site);
NumberedSite numbered_site(const nlohmann::json& record);

// What of the site a task depends on: all but its number.
nlohmann::json without_number(const NumberedSite& site);

nlohmann::json record_of(const BuiltSite& built);
bool is_building(const nlohmann::json& record);
BuiltSite built_site(const nlohmann::json& record);

}  // namespace ilot
