// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"

namespace ilot {

// The sites that a file of footprints asks for, in the order in which they are written; what was found and mended goes
// into the record and to the progress. Error of ExitCode::usage when the file cannot be used.
std::vector<PlannedSite> plan_footprints(const std::filesystem::path& path, const Crs& crs, Progress& progress,
                                         RunRecord& record);

// The other sites that share at least a square metre with it, ascending.
std::vector<std::uint32_t> overlapping(std::span<const PlannedSite> sites, const OutlineMap& map, std::size_t site);

}  // namespace ilot
