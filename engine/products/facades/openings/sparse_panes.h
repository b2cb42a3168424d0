// SPDX-License-Identifier: Apache-2.0
// Panes in the plane of the wall: glass sends back fewer of the rays than the wall about it.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// Finds rectangles in the plane of a wall on which at most half as many points lie as beside each of their sides, where
// neither what stands before them nor the place of a station explains it: some points lie all over them, few rays to
// them were stopped, and each station that saw the wall beside them saw as few points on them. A pane at the foot of
// the wall has no lower side. A side is where the density of points changes (density_step.h), half a line of the scan
// before the first point of the wall. A frame in the plane of the wall looks like the wall, so that the opening may be
// larger than its glass: LocatedEdge::form has it. The order is from bottom to top, and from left to right within a
// row. O(points).
std::vector<FoundRectangle> find_sparse_panes(const RaySamples& samples, double least_size);

// The bytes of memory that the search takes for a wall of this size in metres: its points are counted in cells of 5 cm.
std::uint64_t sparse_pane_bytes(double width, double height);

// Adds sparse panes to other openings: they replace pieces of themselves, and are left out where an opening of about
// their rectangle, or a larger one, was found otherwise.
void add_sparse_panes(std::vector<FoundRectangle>&& panes, std::vector<FoundRectangle>& found);

}  // namespace ilot
