// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/model/facade_opening.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/scale/plan.h"

namespace ilot {

// The numbers that a building has in the result.
struct BuildingNumbers {
  std::uint32_t unit = 0, first_plane = 0;
};

struct MergedRoofs {
  std::vector<std::vector<BuildingNumbers>> numbers;  // by place in the list of areas, then by building of its part
  std::uint64_t labelled = 0;                         // points; one in two outlines counts for both buildings
};

// What the merge of all products knows that buildings need.
struct MergedForRoofs {
  std::vector<ChosenRecord> chosen;     // plan.chosen, with what only the points of all parts say
  std::vector<FacadeOpening> openings;  // of the facades of the merge, by which storeys are counted
};

// Brings the buildings of these areas into the order of one run and writes its files to `staging`, and what run.json
// says of them to the record. `folder` is that of the plan; `parts` has a file of buildings for each area: its part, or
// what store_of_parts has left of it.
MergedRoofs merge_roofs(const std::filesystem::path& folder, const Plan& plan, const MergedForRoofs& other,
                        const std::filesystem::path& parts, const std::vector<std::uint64_t>& areas,
                        const std::filesystem::path& staging, Progress& progress, RunRecord& record);

}  // namespace ilot
