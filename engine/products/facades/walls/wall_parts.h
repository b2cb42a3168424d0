// SPDX-License-Identifier: Apache-2.0
// Which planes continue a wall, and which are walls beside it.
#pragma once
#include <cstddef>
#include <span>

#include "engine/products/facades/walls/segment_grid.h"
#include "engine/products/facades/walls/wall_groups.h"

namespace ilot {

// A segment of a wall, not lower than half a wall.
struct KnownPart {
  WallExtent box;
  std::size_t index = 0;
  bool known = true, wide = true;  // as in SegmentEnds
};

// Whether no part of the wall comes near a segment: scraps of eaves do not join two houses with another one between.
bool is_far(const WallExtent& e, std::span<const KnownPart> parts, double gap);

// Whether a segment stands back or forth from the part of the wall that is nearest to it along the street.
bool steps_off(const WallExtent& e, std::size_t index, std::span<const KnownPart> parts,
               std::span<const SegmentEnds> ends, const WallParams& params);

// Whether parts of the wall, one above the other, are along most of the width and height of a box: fields between
// pilasters are narrower than a wall each.
bool are_along(const WallExtent& e, std::span<const KnownPart> parts);

// Whether a plane as large as a wall fills a stretch of the street in which the wall has no part of its own. Relief has
// its wall above, below, or on both sides.
bool is_beside(const WallExtent& e, const Segment& s, std::span<const KnownPart> parts, const WallParams& params);

}  // namespace ilot
