// SPDX-License-Identifier: Apache-2.0
// How the facades of a house meet: at corners, and where one storey stands before the next.
#pragma once
#include <vector>

#include "engine/model/facade.h"

namespace ilot {

struct JointParams {
  double reach = 0.3;                        // metres from a wall's end to the line in which it meets another
  double least_turn_deg = 20;                // between walls that make a corner
  double least_step = 0.1, most_step = 2.5;  // metres between walls of one front, one above the other
  double metres_per_unit = 1;
};

// The outlines' ends are carried along their walls to the line in which the planes of two facades meet, where both end
// within `reach` of it or one does and the other goes on [Lorraine thesis, 4.2.2]; corners at the same height but for
// `reach` become one point, halfway. So walls close: neighbours share the line, and its ends. The frame begins at the
// new left end. By pairs in the order of the facades; a wall ends at the nearest such line. Each asks those around it.
void close_corners(std::vector<Facade>& facades, const JointParams& params = {});

// Of two walls that look the same way, one above the other and not in one plane, the smaller is a part of the larger:
// a storey that stands out is a protrusion, one that stands back a recess, its outline square to the wall. Elements are
// appended with ids. Each asks those around it.
void add_storey_steps(std::vector<Facade>& facades, const JointParams& params = {});

}  // namespace ilot
