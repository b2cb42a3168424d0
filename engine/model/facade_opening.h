// SPDX-License-Identifier: Apache-2.0
// What other products need to know of the openings of facades.
#pragma once
#include "ilot/geometry.h"

namespace ilot {

struct FacadeOpening {
  Vec3 middle;          // of its ring, CRS
  double out_x, out_y;  // direction out of its wall in plan, of unit length
};

}  // namespace ilot
