// SPDX-License-Identifier: Apache-2.0
// The sites of a plan of roofs: found once for the whole run, and written for each area.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/pass/context.h"
#include "engine/pass/index.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/scale/make_plan.h"
#include "engine/scale/plan.h"
#include "engine/scale/plan_areas.h"

namespace ilot {

// Returns the given sites, or those that are found in the cloud where no footprints are given. Finds how ground and
// buildings are known, and adds what was chosen for `auto` to the plan.
std::vector<PlannedSite> find_sites(const PlanOptions& options, const IndexResult& index,
                                    std::vector<PlannedSite> given, const PassContext& context, Progress& progress,
                                    RunRecord& record, Plan& plan);

// What of a site depends on all sites and points.
struct SiteMarks {
  GridBox extent;                    // of all points, millimetres
  std::vector<std::size_t> sampled;  // sites by which the common shift is measured, ascending
};

// Writes the sites of an area to a file. Returns the hash of what its task depends on: of all but their numbers.
std::string write_sites(const std::filesystem::path& path, const AreaSites& cut, std::span<const PlannedSite> sites,
                        const SiteMarks& marks, PlanArea& area);

}  // namespace ilot
