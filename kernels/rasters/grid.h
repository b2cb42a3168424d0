// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// Square pixels in the xy plane. Everything in scale units relative to the points' anchor; a pixel is closed at its
// lower sides and open at its upper ones. Row by row, the lowest y first.
struct GridFrame {
  std::int64_t x = 0, y = 0;  // lower corner, magnitudes below 2^24
  std::int64_t pixel = 1;     // side, 1 to 2^24
  std::uint32_t width = 0, height = 0;

  std::size_t size() const { return std::size_t{width} * height; }
};

// Per pixel. Where count is 0: low = +infinity, high = -infinity.
struct GridHeights {
  std::vector<std::uint32_t> count;
  std::vector<float> low, high;  // of z
};

// The smallest frame whose pixels hold all points, with corners at multiples of `pixel`: frames of parts of a cloud
// fit on each other. Empty for no points. O(n).
GridFrame frame_of(Points points, std::int64_t pixel);

// Pixel of each point, or kNoPixel outside the frame. out has the size of points. O(n); the same on every machine.
constexpr std::uint32_t kNoPixel = 0xffffffffu;
void pixels_of(Points points, const GridFrame& frame, std::span<std::uint32_t> out);

// Range and accumulation images [Hernandez and Marcotegui 2008, 2.2]: how many points each pixel has, their lowest and
// highest z. Points outside the frame are left out. O(n + pixels); fastest when neighbours in the list are neighbours
// in space.
GridHeights grid_heights(Points points, const GridFrame& frame);

// Adds the images of other points on the same frame. Order of points and of merging cannot show.
void merge(GridHeights& into, const GridHeights& from);

}  // namespace ilot
