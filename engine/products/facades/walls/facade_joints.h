// SPDX-License-Identifier: Apache-2.0
// Joins the facades of a house: at corners, and where one storey stands before the next.
#pragma once
#include <vector>

#include "engine/model/facade.h"

namespace ilot {

struct JointParams {
  double reach = 0.3;                        // metres from a wall's end to the line in which it meets another
  double least_turn_deg = 20;                // between walls that form a corner
  double least_step = 0.1, most_step = 2.5;  // metres between two walls of one front, one of which is above the other
  double metres_per_unit = 1;
};

// Moves the ends of the outlines along their walls to the line in which the planes of two facades meet. This is done
// where both facades end within `reach` of the line, or one ends there and the other continues [Lorraine thesis,
// 4.2.2]. Corners whose heights differ by at most `reach` become one point, halfway between them. Then the walls are
// closed: neighbours share the line and its ends. The frame begins at the new left end. Pairs are processed in the
// order of the facades, and a wall ends at the nearest such line. Each facade looks only at those around it.
void close_corners(std::vector<Facade>& facades, const JointParams& params = {});

// Takes two walls that face the same way, one above the other and not in one plane. The smaller one becomes a part of
// the larger one: a storey that stands out is a protrusion, a storey that is set back is a recess. Its outline is
// perpendicular to the wall. The elements are appended with ids. Each facade looks only at those around it.
void add_storey_steps(std::vector<Facade>& facades, const JointParams& params = {});

}  // namespace ilot
