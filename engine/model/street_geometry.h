// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "engine/model/street.h"

namespace ilot {

// Returns the corners of the rectangle of length and width around an object, counter-clockwise; the centre of the
// rectangle is `middle`.
std::array<Vec3, 4> extent_of(const StreetObject& object, double metres_per_unit);

}  // namespace ilot
