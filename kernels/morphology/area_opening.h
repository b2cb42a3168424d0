// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/rasters/image.h"

namespace ilot {

// Area opening [Hernandez and Marcotegui 2008, 5.1] (Vincent 1994): every pixel comes down to the greatest height at
// which the connected part of the image at or above it that holds the pixel has at least `area` pixels (1 to 2^30);
// kNoHeight where there is no such height. Small peaks go, all else stays as it is. Unique: no order can show.
// Union-find from the top down (Meijster, Wilkinson 2002): O(n) but for the near-constant of union-find; 12 bytes a
// pixel.
Image area_opening(const Image& image, std::uint32_t area, Adjacency adjacency);

}  // namespace ilot
