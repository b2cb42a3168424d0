// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/planes/plane_segments.h"

namespace ilot {

struct SplitMergeParams {
  double epsilon = 0;                   // units; greatest distance of a labelled point from its plane
  double tolerance = 0;                 // units; root mean square distance up to which a cell is one plane
  double min_cos = 0.9961946980917455;  // of the angle between a segment and a cell that joins it [5 degrees]
  double max_step = 0;                  // units; of a cell's centroid from the plane of the segment that it joins
  std::int64_t min_edge = 1;            // units; cells are not split below it
  std::uint32_t min_cell_points = 6;    // fewer are not fitted
  std::uint32_t min_points = 30;        // of a segment
};

// Octree split and merge [A3, after Wang and Tseng 2004]. Split: a cell is cut into eight until its points fit one
// least-squares plane within the tolerance, or are too few. Merge: segments grow from the largest cell over touching
// cells (faces, edges, corners) whose normal agrees and whose centroid lies near the plane, so that surfaces stacked
// one above the other stay apart; the plane is fitted anew after each cell. Where a cell's normal is less sure than
// that angle (few points, or on a line), the points' distance decides instead. Last, each segment, the largest first,
// takes the points within epsilon among its own cells and among cells beside it that no segment has [Lorraine
// thesis, 2.2.2]. Exact sums, ties by position: the answer does not depend on the order of points. Offsets are
// integers, the box's edges below 2^21 units. O(n log n).
PlaneSegments split_merge(Points points, const SplitMergeParams& params);

}  // namespace ilot
