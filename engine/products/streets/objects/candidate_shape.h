// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: the features of form, which tell classes of objects apart at any density.
#pragma once
#include <span>

#include "engine/products/streets/objects/candidate_description.h"

namespace ilot {

// Sets the features from box_length on, of the candidate of each label, in the order of the labels. Max height and the
// middle must be set. O(pixels).
void set_shapes(const PixelLabels& labels, const ComponentImages& images, const RasterScale& scale,
                std::span<ObjectCandidate> candidates);

}  // namespace ilot
