// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: the features of labelled pixels.
#pragma once
#include <vector>

#include "engine/products/streets/objects/layer_patch.h"
#include "engine/products/streets/objects/object_candidates.h"

namespace ilot {

// The images of one component. `own` (its heights) and `slope` (their gradient) have the size of the patch.
struct ComponentImages {
  const Patch& patch;
  Image own, slope;
};

// Describes the candidate of each label, in the order of the labels. The features of passes and parts are left to the
// caller.
std::vector<ObjectCandidate> describe(const PixelLabels& labels, const ComponentImages& images,
                                      const RasterScale& scale, const ObjectCandidateParams& params);

}  // namespace ilot
