// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

#include "engine/pass/context.h"
#include "engine/scale/plan.h"
#include "engine/store/store.h"

namespace ilot {

// Folders of the store that have what each part has of roofs, as files of records by the number of its area.
constexpr const char* kBuildingsOfParts = "part_buildings";  // buildings and the end of the part
constexpr const char* kLabelsOfParts = "part_labels";        // what they give to points

// Makes the store that a run would have where the tasks ended, from the cells of the parts of these areas: points,
// where planes are searched the normals, the files of the cells, and colours and stations where an input has them, and
// where roofs are made the roles and the two folders above. Only the borders of its blocks differ, on which no result
// depends. No input is read. Throws Error for a part that is damaged.
Store store_of_parts(const std::filesystem::path& parts, std::span<const std::uint64_t> areas, const Plan& plan,
                     std::uint64_t block_points, const std::filesystem::path& folder, const PassContext& context);

}  // namespace ilot
