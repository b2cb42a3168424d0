// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Returns for each pixel the lowest height within `reach` pixels in both directions along both axes (a square of 2
// reach + 1). It is kNoHeight where the square has no height. Rows use windows that double with each pass. Columns use
// running minima of blocks (van Herk 1992), several pixels at a time. O(n log reach).
Image box_minimum(const Image& image, std::uint32_t reach);

// The same for those pixels only whose square is inside the image. The result is smaller by `reach` on all four sides.
// The image must be larger than 2 reach in both directions.
Image box_minimum_within(const Image& image, std::uint32_t reach);

}  // namespace ilot
