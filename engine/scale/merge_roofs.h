// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/scale/merge.h"
#include "engine/scale/plan.h"

namespace ilot {

// Brings the buildings of the parts of these areas into the order of one run and writes its files to `staging`, and
// what run.json says of them to the record.
void merge_roofs(const MergeOptions& options, const Plan& plan, const std::vector<std::uint64_t>& areas,
                 const std::filesystem::path& staging, Progress& progress, RunRecord& record);

}  // namespace ilot
