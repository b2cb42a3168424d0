// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ilot {

struct GroundParams {
  double flat = 1;           // metres; heights of neighbours on the ground differ by at most this
  double longest_gap = 0.5;  // metres; longest gap between scan lines that is closed
  double gap_step = 0.2;     // metres; greatest height difference between the two sides of such a gap
  double longest_link = 10;  // metres; longest link over a shadow between regions of the ground
};

}  // namespace ilot
