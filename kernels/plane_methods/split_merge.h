// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/planes/plane_segments.h"

namespace ilot {

struct SplitMergeParams {
  double epsilon = 0;                   // units; greatest distance of a labelled point from its plane
  double tolerance = 0;                 // units; greatest root mean square distance of a cell that is one plane
  double min_cos = 0.9961946980917455;  // of the angle between a segment and a cell that joins it [5 degrees]
  double max_step = 0;                // units; greatest distance of a joining cell's centroid from the segment's plane
  std::int64_t min_edge = 1;          // units; cells are not split below it
  std::uint32_t min_cell_points = 6;  // cells with fewer points are not fitted
  std::uint32_t min_points = 30;      // fewest points of a segment
};

// Octree split and merge [A3, after Wang and Tseng 2004]. Split: a cell is divided into eight until its points fit one
// least-squares plane within the tolerance, or are too few. Merge: segments grow from the largest cell over touching
// cells (faces, edges, corners) whose normal agrees and whose centroid is near the plane, so that surfaces stacked one
// above the other stay separate. The plane is fitted again after each cell. Where the normal of a cell is less certain
// than that angle (few points, or points on a line), the distance of the points decides instead. Last, each segment,
// the largest first, takes the points within epsilon from its own cells and from neighbouring cells that belong to no
// segment [Lorraine thesis, 2.2.2]. Sums are exact and ties are decided by position, so the result does not depend on
// the order of points. Offsets are integers, and the edges of the box are below 2^21 units. O(n log n).
PlaneSegments split_merge(Points points, const SplitMergeParams& params);

}  // namespace ilot
