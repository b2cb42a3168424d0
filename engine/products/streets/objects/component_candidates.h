// SPDX-License-Identifier: Apache-2.0
// Inside of find_object_candidates: one component, taken apart and joined again.
#pragma once
#include <vector>

#include "engine/products/streets/objects/layer_patch.h"
#include "engine/products/streets/objects/object_candidates.h"

namespace ilot {

struct ComponentCandidates {
  PixelLabels labels;  // of the patch: the parts as they were separated
  std::vector<ObjectCandidate>
      candidates;  // those parts, then what joins two of these or of those; parts by their place here, from 1
};

// Half of the gap over which parts may be one thing, pixels.
std::uint32_t gap_reach(const RasterScale& scale, const ObjectCandidateParams& params);

// The things of the component of that number in the layer "components".
ComponentCandidates candidates_of_component(const Patch& patch, std::uint32_t component, const RasterScale& scale,
                                            const ObjectCandidateParams& params);

}  // namespace ilot
