// SPDX-License-Identifier: Apache-2.0
// The position of a step between the points above it and those below.
#pragma once
#include <span>

namespace ilot {

// An upper point and the lower one beside it, as distances from a common line along the step (metres, signed).
struct StepGap {
  double upper = 0, lower = 0;
};

// Returns the offset of the parallel line that separates most of the pairs. Among the offsets that do so, it is the one
// nearest to the upper points: `spacing` beyond the last of them, but at most halfway. The reason is that an upper edge
// is measured up to its end, while the lower points may begin only beyond its shadow. `spacing` is the expected
// distance of the outermost upper point from the edge: the area of a point divided by the length of the step. Ties: the
// widest range of offsets, then the lowest. Returns 0 without pairs. O(n log n).
double step_offset(std::span<const StepGap> gaps, double spacing);

}  // namespace ilot
