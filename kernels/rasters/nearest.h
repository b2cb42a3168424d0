// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

constexpr std::uint32_t kNoNearest = 0xffffffffu;

struct NearestPixels {
  std::vector<std::uint32_t> pixel;     // row by row; kNoNearest: none within reach
  std::vector<std::uint32_t> distance;  // steps from side to side; reach + 1 where there is none
};

// Of each pixel the nearest one that has a height, in steps from side to side, of equally near ones the first, row by
// row: itself where it has one. Lines up and down, then rows to both sides, each value a distance and a pixel in one
// number (distance by sweeps: Rosenfeld and Pfaltz 1968). O(n), 8 bytes a pixel; the columns several at a time.
// `reach` below 2^31.
NearestPixels nearest_pixels(const Image& image, std::uint32_t reach);

}  // namespace ilot
