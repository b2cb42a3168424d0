// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/pass/context.h"
#include "engine/scale/merge/merge_roofs.h"
#include "engine/store/store.h"

namespace ilot {

// What was chosen for roofs, in the words of a run, which counts the roles that were found by shape. The store is as
// below.
std::vector<ChosenRecord> chosen_of_roofs(const Plan& plan, const Store& store, const PassContext& context);

// Writes the column "roof" of every block of a store of parts, which has the column "role", from the labels that the
// buildings of these areas give: `labels` has a file of them for each (kLabelsOfParts).
void merge_roof_labels(const Store& store, const std::filesystem::path& labels, const std::vector<std::uint64_t>& areas,
                       const MergedRoofs& roofs, const PassContext& context);

}  // namespace ilot
