// SPDX-License-Identifier: Apache-2.0
// Inside of find_object_candidates: what labelled pixels look like.
#pragma once
#include <vector>

#include "engine/products/streets/objects/layer_patch.h"
#include "engine/products/streets/objects/object_candidates.h"

namespace ilot {

// A component as it is worked on: `own` and `slope`, its heights and their gradient, are as large as the patch.
struct ComponentImages {
  const Patch& patch;
  Image own, slope;
};

// The things that the labels are, in their order; passes and parts are left to the caller.
std::vector<ObjectCandidate> describe(const PixelLabels& labels, const ComponentImages& images,
                                      const RasterScale& scale, const ObjectCandidateParams& params);

}  // namespace ilot
