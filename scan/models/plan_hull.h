// SPDX-License-Identifier: Apache-2.0
// The convex hull of points in a plane, whose corners are rounded to steps so that it does not depend on rounding.
#pragma once
#include <span>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot::scan {

// Returns the corners counter-clockwise, rounded to 1 / steps_per_unit.
std::vector<FlatPoint> plan_hull(std::span<const FlatPoint> points, double steps_per_unit);

}  // namespace ilot::scan
