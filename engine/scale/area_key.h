// SPDX-License-Identifier: Apache-2.0
// By what a part is known: a hash of everything that decides its bytes. A part stays valid in every plan in which its
// area has the same key.
#pragma once
#include <string>

#include "engine/scale/plan.h"

namespace ilot {

// The key of an area: the program, the settings, what the plan froze for tasks, the boxes, the contents of the inputs,
// the stations of their rows where the part has them, and `sites`, the hash of its sites. Neither the number of the
// area nor the other areas and their inputs matter.
std::string area_key(const Plan& plan, const PlanArea& area, const std::string& sites);

}  // namespace ilot
