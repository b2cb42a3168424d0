// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scan/optics/exact_math.h"
#include "scan/optics/part.h"

namespace ilot::scan {

// Where a thing stands and looks to: turned up about its y axis, then about z, then moved.
struct Pose {
  Vec3 base;
  SinCos heading;
  SinCos pitch;

  Vec3 direction(Vec3 local) const;
  Vec3 place(Vec3 local) const { return direction(local) + base; }
};

Solid placed(const Solid& solid, const Pose& pose);

// A box on the ground plan that may be turned.
struct PlanBox {
  double x = 0, y = 0;  // centre
  SinCos heading;
  double half_length = 0, half_width = 0;  // along and across the heading
};

// Whether two boxes come closer than `apart`; for a negative one, whether they overlap by more than that. Exact for
// boxes that overlap, and for separate ones no further than the gap between their sides.
bool closer(const PlanBox& a, const PlanBox& b, double apart);

}  // namespace ilot::scan
