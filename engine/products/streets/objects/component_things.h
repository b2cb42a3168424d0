// SPDX-License-Identifier: Apache-2.0
// Inside of find_things: one component, taken apart and joined again.
#pragma once
#include <vector>

#include "engine/products/streets/objects/layer_patch.h"
#include "engine/products/streets/objects/things.h"

namespace ilot {

struct ComponentThings {
  PixelLabels labels;  // of the patch: the parts as they were separated
  std::vector<Thing>
      things;  // those parts, then what joins two of these or of those; parts by their place here, from 1
};

// Half of the gap over which parts may be one thing, pixels.
std::uint32_t gap_reach(const RasterScale& scale, const ThingsParams& params);

// The things of the component of that number in the layer "components".
ComponentThings things_of_component(const Patch& patch, std::uint32_t component, const RasterScale& scale,
                                    const ThingsParams& params);

}  // namespace ilot
