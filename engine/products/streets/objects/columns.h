// SPDX-License-Identifier: Apache-2.0
// Inside of find_object_candidates: what stands free as a column, cut out of the parts that hold it.
#pragma once
#include <utility>
#include <vector>

#include "engine/products/streets/objects/object_candidates.h"
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {

// Where nothing lies in a ring around pixels, from `widest` on and `apart` wide, over a run of bins of at least
// `least_run`: what hangs together with them in those bins, two pixels being the sampling step, is a column if it is no
// wider than `widest` [the isolation of Cabo et al. 2014, ISPRS J. 87]. `occupancy` of one component, 0 elsewhere.
// Labels by first pixel; O(n log of a column).
PixelLabels columns_of(const std::vector<Occupancy>& occupancy, std::uint32_t width, std::uint32_t height,
                       const RasterScale& scale, const ColumnParams& params = {});

// A part that was cut in two: what is left of it, and the column, a label of its own behind all others.
struct ColumnCut {
  std::uint32_t rest = 0, column = 0;
};

// Gives the columns labels of their own. The part that holds most of a column (ties: the lowest) is what it is cut
// from; a part is only cut where at least `least` pixels of it are left. O(n).
std::vector<ColumnCut> cut_columns(const PixelLabels& columns, std::uint32_t least, PixelLabels& parts);

}  // namespace ilot
