// SPDX-License-Identifier: Apache-2.0
// The candidates that stand at places which a person names.
#pragma once
#include <cstdint>

#include "engine/products/streets/make_streets.h"

namespace ilot {

// Returns the separated part at a place (CRS), or the nearest one within half a metre; 0 = none.
std::uint32_t part_at(const FoundStreet& street, Vec3 place);

}  // namespace ilot
