// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// The number of points of a pixel that are high above the ground, and of those among them that are on a smooth surface
// and are the only echo of their pulse.
struct HighPoints {
  std::uint32_t high = 0, smooth = 0;
};

// The halo of a pixel, in pixels.
constexpr std::uint32_t kMaskHalo = 3;

// Marks the pixels of buildings, row by row, with 1, all others with 0. A pixel is a candidate if most of the high
// points in the three by three pixels around it are smooth. It is marked if it is in a square of three by three
// candidates. Trees are rough and give several echoes. The result is exact and local. O(pixels).
std::vector<std::uint8_t> building_mask(const std::vector<HighPoints>& pixels, std::uint32_t width,
                                        std::uint32_t height);

}  // namespace ilot
