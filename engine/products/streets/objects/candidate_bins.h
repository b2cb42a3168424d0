// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: the features of how the occupied bins of a candidate lie. Leaves fill a volume
// loosely, the sides of a box are sheets, and a post is a line, whatever their outlines from above are.
#pragma once
#include <span>

#include "engine/products/streets/objects/candidate_description.h"

namespace ilot {

// Sets the features from neighbour_bins on, of the candidate of each label, in the order of the labels. A bin is a
// voxel: one pixel of the image, and one height bin of its occupancy.
// Of a level bar of one bin the two smallest eigenvalues are equal but for rounding, so level_normal says nothing
// there, as upright_axis where the two largest are equal. O(pixels) and one eigenproblem for each candidate.
void set_bin_features(const PixelLabels& labels, const ComponentImages& images, const RasterScale& scale,
                      std::span<ObjectCandidate> candidates);

}  // namespace ilot
