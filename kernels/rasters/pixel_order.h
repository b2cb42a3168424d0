// SPDX-License-Identifier: Apache-2.0
// Inside of the raster kernels: pixels sorted by height.
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Indices of the pixels that have a height, the highest first, equal ones by position. Counting sort over 12 bits of
// the height at a time: O(n) a pass, one or two for the heights of a street. 4 to 12 bytes a pixel.
std::vector<std::uint32_t> pixels_from_the_top(const Image& image);

}  // namespace ilot
