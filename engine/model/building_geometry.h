// SPDX-License-Identifier: Apache-2.0
// Measurements on the model of a building. The public interface defines those that are not here.
#pragma once
#include <span>

#include "ilot/roofs.h"

namespace ilot {

// Returns the last of the levels that is a solid; nullptr when there is none.
const Building* finest_solid(std::span<const Building> levels);

}  // namespace ilot
