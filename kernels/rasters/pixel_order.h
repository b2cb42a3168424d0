// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels: pixels sorted by height.
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Returns the indices of the pixels that have a height, the highest first, equal ones by position. It is a counting
// sort over up to 16 bits of the height at a time: one pass when the heights of the image differ by less than 2^16,
// otherwise two. O(n), 8 bytes per pixel.
std::vector<std::uint32_t> pixels_from_the_top(const Image& image);

}  // namespace ilot
