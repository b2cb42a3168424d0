// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ilot {

struct ArtefactParams {
  double least_height = 0.1;  // metres above the ground around
  double ring_reach = 5;      // metres; the level of the ground is spread so far around it
  double highest_kerb = 0.3;  // metres; greatest height of a plateau that is pavement
  double least_plateau = 1;   // square metres; least area of a plateau that is pavement
};

}  // namespace ilot
