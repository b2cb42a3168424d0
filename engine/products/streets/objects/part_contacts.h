// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: the heights at which candidates stand, and the heights at which they touch.
#pragma once
#include <span>
#include <vector>

#include "engine/products/streets/objects/object_candidates.h"
#include "engine/products/streets/objects/part_joins.h"
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {

// Sets the features of candidates that come from the occupancy of their pixels, from upright_share on. `candidates` are
// the parts of a component, then the candidates that the joins make. Two parts touch in a bin where both have a point
// in that bin and these points are at most the sampling step (two pixels) apart. O(n + joins parts log parts).
void set_contacts(const PixelLabels& parts, const std::vector<Occupancy>& occupancy, std::span<const Join> joins,
                  const RasterScale& scale, std::span<ObjectCandidate> candidates);

}  // namespace ilot
