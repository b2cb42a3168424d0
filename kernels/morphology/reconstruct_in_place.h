// SPDX-License-Identifier: Apache-2.0
// Inside of the raster kernels: reconstruction by erosion in place, for all that is made of it.
#pragma once
#include <span>

#include "kernels/rasters/padded.h"

namespace ilot {

// Lowers `g` (never below `f`) to the reconstruction of f from g. Both padded, with kAboveAll on the border; g >= f.
void reconstruct_in_place(const PaddedFrame& frame, Adjacency adjacency, std::span<const Height> f,
                          std::span<Height> g);

}  // namespace ilot
