// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Points of a pixel that stand high above the ground, and those of them that lie on a smooth surface and alone in their
// pulse.
struct HighPoints {
  std::uint32_t high = 0, smooth = 0;
};

// How far a pixel's answer looks.
constexpr std::uint32_t kMaskHalo = 3;

// Which pixels are buildings', row by row, 1 or 0: those around which (three by three pixels) most of the high points
// are smooth, where three by three such pixels lie together. Trees are rough and come back several times. Exact and
// local. O(pixels).
std::vector<std::uint8_t> building_mask(const std::vector<HighPoints>& pixels, std::uint32_t width,
                                        std::uint32_t height);

}  // namespace ilot
