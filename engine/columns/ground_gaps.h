// SPDX-License-Identifier: Apache-2.0
// Heights of the ground where no point shows it: under buildings, cars and trees.
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Gives every pixel without a height the mean of the nearest heights in the eight directions of the raster, at most
// `reach` pixels away, weighted by the inverse square of their distance [Shepard 1968]. A pixel that has no two of them
// on opposite sides (within 45 degrees) stays without a height: it lies beyond the ground that was seen and not
// between. Local: the result of a pixel depends on the pixels within reach alone. O(pixels).
Image filled_ground(const Image& ground, std::uint32_t reach);

// Smooths what was filled, because rays in eight directions hit scattered heights from one pixel and miss them from the
// next: every filled pixel gets the mean of the heights of the pixels around it and its own, kSmoothings times.
// Measured heights stay. Pixels farther away than kSmoothings do not matter. O(pixels).
constexpr std::uint32_t kSmoothings = 2;
Image smoothed_fill(const Image& ground, Image filled);

}  // namespace ilot
