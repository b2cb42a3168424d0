// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/rasters/image.h"

namespace ilot {

// Area opening [Hernandez and Marcotegui 2008, 5.1] (Vincent 1994). Each pixel is lowered to the greatest height at
// which the connected component of pixels at or above it that contains the pixel has at least `area` pixels (1 to
// 2^30). The pixel gets kNoHeight where there is no such height. Small peaks are removed and all else stays as it is.
// The result is unique, so no order of work matters. The method is union-find from the top down (Meijster, Wilkinson
// 2002). It is O(n) up to the nearly constant factor of union-find and needs 12 bytes per pixel.
Image area_opening(const Image& image, std::uint32_t area, Adjacency adjacency);

}  // namespace ilot
