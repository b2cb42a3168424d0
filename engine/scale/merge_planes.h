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

// Goes on where the tasks of planes ended, with the steps of a run: joins planes over cells, extends and outlines them.
// Writes the files of a run to `staging`, and what run.json says of them to the record. `store` is a folder for blocks,
// which is emptied first and removed at the end.
void merge_planes(const MergeOptions& options, const Plan& plan, const std::vector<std::uint64_t>& areas,
                  const std::filesystem::path& store, const std::filesystem::path& staging, Progress& progress,
                  RunRecord& record);

}  // namespace ilot
