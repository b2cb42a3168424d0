// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: thin upright things, which have fewer pixels than the least area of a part.
#pragma once
#include <vector>

#include "engine/products/streets/objects/object_candidates.h"
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {

// Whether points at these heights are of something upright and no strays: they fill a run of bins of the least height
// of a column.
bool stands_upright(Occupancy bins, const RasterScale& scale, const ColumnParams& params = {});

// Gives labels to thin upright things. Separation drops what covers less than the least area: a post of two pixels, a
// plate seen along its plane, or a column of which single profiles were scanned. Here pixels of `heights` without a
// label that are no farther than two pixels (the sampling step) from each other are a group. A group that stands
// upright becomes a part of its own, with a label after all others. The labels of groups are ordered by first pixel.
// `occupancy` is that of one component and 0 elsewhere. O(n).
void add_thin_parts(const Image& heights, const std::vector<Occupancy>& occupancy, const RasterScale& scale,
                    const ColumnParams& params, PixelLabels& parts);

}  // namespace ilot
