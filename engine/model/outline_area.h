// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/model/outline.h"

namespace ilot {

// Area of the outline, holes left out, in CRS units squared. Rings lie in one plane. O(vertices).
double area_of(const Outline& outline);

}  // namespace ilot
