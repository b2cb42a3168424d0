// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/model/street.h"

namespace ilot {

// Splits a plan into areas that are too far apart for one sheet: things that are within 1 km of each other are in one
// area, and those that are more than 3 km from all others of it are in another. The areas are in the order of their
// rows of squares from the south, then from the west; the order inside of them is that of the plan. A plan without
// anything is one area. O(n log n).
std::vector<StreetPlan> street_areas(const StreetPlan& plan, double metres_per_unit);

}  // namespace ilot
