// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/model/outline.h"

namespace ilot {

// Returns the area of the outline without its holes, in CRS units squared. Rings are in one plane. O(vertices).
double area_of(const Outline& outline);

}  // namespace ilot
