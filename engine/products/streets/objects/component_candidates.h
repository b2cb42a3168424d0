// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: one connected component is separated into parts, and the parts are joined again.
#pragma once
#include <vector>

#include "engine/products/streets/objects/layer_patch.h"
#include "engine/products/streets/objects/object_candidates.h"

namespace ilot {

struct ComponentCandidates {
  PixelLabels labels;                       // of the patch; the parts as separation gave them
  std::vector<ObjectCandidate> candidates;  // the separated parts, then joins of two earlier candidates; `parts` are
                                            // positions in this list, from 1
};

// Half of the widest gap over which two parts may still be one object, in pixels.
std::uint32_t gap_reach(const RasterScale& scale, const ObjectCandidateParams& params);

// The object candidates of the component with this number in the layer "components".
ComponentCandidates candidates_of_component(const Patch& patch, std::uint32_t component, const RasterScale& scale,
                                            const ObjectCandidateParams& params);

}  // namespace ilot
