// SPDX-License-Identifier: Apache-2.0
// The planes along a wall: its relief, or the wall itself behind its pilasters.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/products/facades/walls/segment_grid.h"
#include "engine/products/facades/walls/wall_groups.h"
#include "engine/products/facades/walls/wall_parts.h"

namespace ilot {

// Choice: relief that is twisted by more is a wall of its own.
inline constexpr double kParallelDeg = 5;  // greatest angle between a plane of the relief and its wall

// The segments that are parallel to a wall, along it and within the distances of relief, as places in the list of the
// grid, in the order of their index. The segments of the wall are in order.
std::vector<std::size_t> relief_of(const SegmentGrid& grid, const WallParams& params, std::span<const KnownPart> parts,
                                   const WallGroup& group);

// The largest segment (its index) of a plane along the wall whose parts have a larger area than the wall, where there
// is one: pilasters form one plane, and each of them may be larger than each bay between them, but the bays are the
// wall. Only parts that no segment of the wall surrounds count: panes lie in the holes of one. Segments that are taken
// do not count.
std::optional<std::size_t> larger_plane(const SegmentGrid& grid, const std::vector<char>& taken,
                                        const WallParams& params, std::span<const KnownPart> parts,
                                        const WallGroup& group);

}  // namespace ilot
