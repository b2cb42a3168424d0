// SPDX-License-Identifier: Apache-2.0
// Inside of find_object_candidates: at which heights things stand, and at which they touch.
#pragma once
#include <span>
#include <vector>

#include "engine/products/streets/objects/object_candidates.h"
#include "engine/products/streets/objects/part_joins.h"
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {

// Sets the features of things that the occupancy of their pixels gives, from upright_share on: `parts` of a component,
// then what the joins make of them. Two parts touch in a bin where both have a point in it no farther apart than the
// sampling step, two pixels. O(n + joins parts log parts).
void set_contacts(const PixelLabels& parts, const std::vector<Occupancy>& occupancy, std::span<const Join> joins,
                  const RasterScale& scale, std::span<ObjectCandidate> candidates);

}  // namespace ilot
