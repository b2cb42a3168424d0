// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scan/optics/exact_math.h"
#include "scan/optics/part.h"

namespace ilot::scan {

// The position and direction of an object: it is turned up about its y axis, then turned about z, then moved.
struct Pose {
  Vec3 base;
  SinCos heading;
  SinCos pitch;

  Vec3 direction(Vec3 local) const;
  Vec3 place(Vec3 local) const { return direction(local) + base; }
};

Solid placed(const Solid& solid, const Pose& pose);

// A box in the ground plan that may be turned.
struct PlanBox {
  double x = 0, y = 0;  // centre
  SinCos heading;
  double half_length = 0, half_width = 0;  // along and across the heading
};

// Returns whether two boxes are closer than `apart`. If `apart` is negative, returns whether they overlap by more than
// its absolute value. The result is exact for boxes that overlap. For separate boxes the distance is at most the gap
// between their sides.
bool closer(const PlanBox& a, const PlanBox& b, double apart);

}  // namespace ilot::scan
