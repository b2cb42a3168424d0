// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "engine/model/street.h"

namespace ilot {

// Returns the corners of the rectangle of length and width around an object, counter-clockwise; the centre of the
// rectangle is `middle`.
std::array<Vec3, 4> extent_of(const StreetObject& object, double metres_per_unit);

// Returns the corners of a polygon of 32 sides around the crown of a tree, counter-clockwise, with the crown's radius.
std::array<Vec3, 32> crown_of(const StreetTree& tree, double metres_per_unit);

}  // namespace ilot
