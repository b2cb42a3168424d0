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

// Plans the sites of a file of footprints, in the order in which they are written. Their ids are those of the attribute
// `id_field`, or of the first usual one where it is empty. What is found and repaired goes to
// the record and to the progress. Throws an Error of ExitCode::usage when the file cannot be used.
std::vector<PlannedSite> plan_footprints(const std::filesystem::path& path, const std::string& id_field, const Crs& crs,
                                         Progress& progress, RunRecord& record);

// Returns the other sites that share at least one square metre with this site, ascending.
std::vector<std::uint32_t> overlapping(std::span<const PlannedSite> sites, const OutlineMap& map, std::size_t site);

}  // namespace ilot
