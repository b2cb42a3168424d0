// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: what of a candidate lies in each band of height above the ground, and how smooth
// it is from above. A car has its length in the lower bands and its cabin in the next, a pedestrian is as wide in all
// of them, and the crown of a small tree begins above a stem.
#pragma once
#include <span>

#include "engine/products/streets/objects/candidate_description.h"

namespace ilot {

// Sets the features from band_share on, and own_top, of the candidate of each label, in the order of the labels. A bin
// belongs to the band that contains its middle. The own top is where no point follows for a metre, as below the crown
// of a tree above a car, or the highest point. O(pixels times bands).
void set_band_features(const PixelLabels& labels, const ComponentImages& images, const RasterScale& scale,
                       std::span<ObjectCandidate> candidates);

}  // namespace ilot
