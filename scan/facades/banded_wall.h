// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scan/facades/facade_builder.h"

namespace ilot::scan {

// Courses of stone between horizontal grooves.
struct Bands {
  double pitch = 0.42;    // metres from groove to groove
  double groove = 0.035;  // height of a groove
  double depth = 0.02;    // of the grooves
};

// Adds a wall from z0 to z1 with openings. Its courses lie in the plane of the facade. Each course is an element of the
// kind `course`. All grooves together are one element of the kind `joint`.
void add_banded_wall(FacadeBuilder& facade, double x0, double x1, double z0, double z1,
                     const std::vector<Opening>& openings, const Bands& bands, Finish course, Finish joint);

// Returns the parts of [x0, x1] at height z that are in no opening, from left to right.
std::vector<std::array<double, 2>> solid_intervals(double x0, double x1, double z,
                                                   const std::vector<Opening>& openings);

}  // namespace ilot::scan
