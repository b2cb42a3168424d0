// SPDX-License-Identifier: Apache-2.0
// Cuts the planes of a run where the wall that they follow steps back or forth: planes of walls that differ by some
// centimetres are often one.
#pragma once
#include <span>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/facades/facade_gathering.h"
#include "engine/products/facades/walls/wall_groups.h"

namespace ilot {

// Segments and their ends, one each. A segment that was cut stands once for each of its pieces, with its own id; box,
// plane, points, area and rms are those of the piece.
struct WallPieces {
  std::vector<Segment> segments;
  std::vector<SegmentEnds> ends;
};

// Reads the points of each upright segment that may be a wall once. The store must have the column "plane". O(points of
// the boxes of these segments).
WallPieces wall_pieces(const FacadeWork& work, std::span<const Segment> segments, const WallParams& params,
                       const PassContext& context);

}  // namespace ilot
