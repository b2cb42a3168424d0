// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// The lowest height within `reach` pixels of each pixel, both ways along both axes (a square of 2 reach + 1); kNoHeight
// where there is none in it. Rows, then columns, in windows that double with each pass: O(n log reach), eight pixels at
// a time, which is less than running minima of blocks (van Herk 1992) take for any reach of a tile.
Image box_minimum(const Image& image, std::uint32_t reach);

}  // namespace ilot
