// SPDX-License-Identifier: Apache-2.0
// The sites of a plan of roofs: found once for the whole run, and written for each area.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/scale/make_plan.h"
#include "engine/scale/plan.h"
#include "engine/scale/plan_areas.h"
#include "engine/store/store.h"

namespace ilot {

// Finds how ground and buildings are known where footprints are given, from the points of each class.
void find_roles(const std::array<std::uint64_t, 256>& classes, Plan& plan);

// Returns the sites that are found in a store of all points where no footprints are given. Finds how ground and
// buildings are known, and adds what was chosen for `auto` to the plan.
std::vector<PlannedSite> find_sites(const PlanOptions& options, const Store& store, const PassContext& context,
                                    Progress& progress, RunRecord& record, Plan& plan);

// What of a site depends on all sites and points.
struct SiteMarks {
  GridBox extent;                    // of all points, millimetres
  std::vector<std::size_t> sampled;  // sites by which the common shift is measured, ascending
};

// Writes the sites of an area to a file. Returns the hash of what its task depends on: of all but their numbers.
std::string write_sites(const std::filesystem::path& path, const AreaSites& cut, std::span<const PlannedSite> sites,
                        const SiteMarks& marks, PlanArea& area);

}  // namespace ilot
