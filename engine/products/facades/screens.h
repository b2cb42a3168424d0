// SPDX-License-Identifier: Apache-2.0
// Tells scaffolds and fences before a wall from walls: most rays go on to the wall behind them.
#pragma once
#include <functional>
#include <vector>

#include "engine/products/facades/facade_gathering.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// How far a wall stands behind another one that faces the same way, in metres, where it is 0.3 to 2 m behind it along
// most of its length; 0 otherwise.
double depth_behind(const WallGroup& front, const WallGroup& wall, double metres_per_unit);

// Whether in more than a third of the cells of a wall in which rays met it, or the wall that is `behind` metres behind
// it, most met the wall behind. O(points).
bool is_screen(const RaySamples& samples, double behind);

// Takes the screens out of the wanted walls and returns them. Only a wall before another one is looked at, so that
// hardly any wall is read once more. The store must have the column "plane".
std::vector<WallGroup> take_screens(const FacadeWork& work, const std::function<bool(const WallGroup&)>& wanted,
                                    std::vector<WallGroup>& walls);

}  // namespace ilot
