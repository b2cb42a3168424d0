// SPDX-License-Identifier: Apache-2.0
// Where a step lies between the points above it and those below.
#pragma once
#include <span>

namespace ilot {

// An upper point and the lower one beside it, as distances from a common line along the step (metres, signed).
struct StepGap {
  double upper = 0, lower = 0;
};

// The offset of the parallel that parts most of the pairs. Of the offsets that do so the one nearest to the upper
// points, `spacing` beyond the last of them but at most halfway: an upper edge is measured up to its end, while the
// lower points may begin only beyond its shadow. `spacing`: how far the outermost upper point is expected to stay short
// of the edge, the area that a point stands for over the length of the step. Ties: the widest range of offsets, then
// the lowest. 0 without pairs. O(n log n).
double step_offset(std::span<const StepGap> gaps, double spacing);

}  // namespace ilot
