// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

#include "engine/pass/context.h"
#include "engine/scale/plan.h"
#include "engine/store/store.h"

namespace ilot {

// Makes the store that a run would have where the tasks ended, from the cells of the parts of these areas: points, and
// where planes are searched the normals, the files of the cells, and colours and stations where an input has them. Only
// the borders of its blocks differ, on which no result depends. No input is read. Throws Error for a part that is
// damaged.
Store store_of_parts(const std::filesystem::path& parts, std::span<const std::uint64_t> areas, const Plan& plan,
                     std::uint64_t block_points, const std::filesystem::path& folder, const PassContext& context);

}  // namespace ilot
