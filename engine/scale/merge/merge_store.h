// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/scale/merge/merge.h"
#include "engine/scale/plan.h"

namespace ilot {

// Goes on where the tasks ended: makes one store of the parts of these areas, and makes the products with the functions
// of a run. Writes the files of a run to `staging`, and what run.json says of them to the record. `store` is a folder
// for blocks, which is emptied first and removed at the end; with options.labels the labels of all points stay in it.
void merge_store(const MergeOptions& options, const Plan& plan, const std::vector<std::uint64_t>& areas,
                 const std::filesystem::path& store, const std::filesystem::path& staging, Progress& progress,
                 RunRecord& record);

}  // namespace ilot
