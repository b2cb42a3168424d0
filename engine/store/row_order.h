// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/store/store.h"

namespace ilot {

// Returns the points of a block in ascending input order. `order` is its column of that name. The result is kept in the
// column "sorted" u32 and read from there the next time. O(points).
std::vector<std::uint32_t> points_by_row(const Store& store, std::uint32_t block, std::span<const InputOrder> order);

}  // namespace ilot
