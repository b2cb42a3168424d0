// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: columns (thin upright regions that stand free), cut out of the parts that contain
// them.
#pragma once
#include <utility>
#include <vector>

#include "engine/products/streets/objects/object_candidates.h"
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {

// Finds columns by isolation [the isolation of Cabo et al. 2014, ISPRS J. 87]. Around some pixels there is a ring that
// begins at `widest` and is `apart` wide. If this ring is empty over a run of bins of at least `least_run`, then the
// pixels connected to the inner ones in these bins are a column if they are together no wider than `widest`. Pixels are
// connected over at most two pixels, the sampling step. `occupancy` is that of one component and 0 elsewhere. The
// labels are ordered by first pixel. O(n log of a column).
PixelLabels columns_of(const std::vector<Occupancy>& occupancy, std::uint32_t width, std::uint32_t height,
                       const RasterScale& scale, const ColumnParams& params = {});

// A part that was cut in two: `rest` is what is left of it, and `column` is a new label after all others.
struct ColumnCut {
  std::uint32_t rest = 0, column = 0;
};

// Gives each column a label of its own. A column is cut out of the part that contains most of it (ties: the lowest
// label). A part is cut only where at least `least` of its pixels are left. O(n).
std::vector<ColumnCut> cut_columns(const PixelLabels& columns, std::uint32_t least, PixelLabels& parts);

}  // namespace ilot
