// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels: reconstruction by erosion in place, which the other operations use.
#pragma once
#include <span>

#include "kernels/rasters/padded.h"

namespace ilot {

// Lowers `g` (never below `f`) to the reconstruction of f from g. Both are padded, with kAboveAll on the border, and g
// >= f.
void reconstruct_in_place(const PaddedFrame& frame, Adjacency adjacency, std::span<const Height> f,
                          std::span<Height> g);

}  // namespace ilot
