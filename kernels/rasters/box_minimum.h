// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// The lowest height within `reach` pixels of each pixel, both ways along both axes (a square of 2 reach + 1); kNoHeight
// where there is none in it. Rows in windows that double with each pass, then columns by running minima of blocks (van
// Herk 1992), several pixels at a time: O(n log reach).
Image box_minimum(const Image& image, std::uint32_t reach);

// Of the pixels alone whose square lies in the image: smaller by `reach` on all four sides. More than 2 reach both
// ways.
Image box_minimum_within(const Image& image, std::uint32_t reach);

}  // namespace ilot
