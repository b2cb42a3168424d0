// SPDX-License-Identifier: Apache-2.0
// Which walls lie near each other.
#pragma once
#include <cstddef>
#include <functional>
#include <span>

#include "engine/products/facades/walls/wall_groups.h"

namespace ilot {

// Choice: a row may bend; walls that turn by more meet in a corner.
constexpr double kTurnInRowDeg = 10;
// Choice: the place of a step is known better; walls that overlap by more lie one before the other.
constexpr double kCommonByChance = 0.5;  // metres

// Calls visit(i, k) for each wall i and every other wall k whose plan, grown by the reach of relief, comes within
// `reach` metres of its own, in the order of i and k. The plans are those before the first visit, so a visit may change
// the walls. O(walls + pairs).
void for_each_near_wall(std::span<const WallGroup> walls, double reach, const WallParams& params,
                        const std::function<void(std::size_t, std::size_t)>& visit);

}  // namespace ilot
