// SPDX-License-Identifier: Apache-2.0
// The last word on every point: which plane it lies on, measured against the planes as they are written.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/segments/join_pass.h"

namespace ilot {

// A plane and the points that were labelled with it.
struct PlaneTally {
  Moments moments;               // relative to the plane's anchor
  std::uint64_t content_id = 0;  // a function of the set of points, relative to their tiles
  IndexBox box{{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};
};

// Writes "plane" (u32: 0 = none, else 1 + index into the joined planes) of every block, and returns what each plane
// got. A point's candidates are its own plane and those of at least two of its 12 nearest neighbours within the
// connectivity, all within epsilon of it; between two of them decides the bisector that parts their points. A point
// alone among points of one other plane goes to that plane if it lies within epsilon. Points of dropped planes and
// points without one take part like all others. Points that are not wanted get none.
std::vector<PlaneTally> label_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& cell_planes,
                                   const JoinedPlanes& joined, const PassContext& context);

}  // namespace ilot
