// SPDX-License-Identifier: Apache-2.0
// The plain data that raster kernels work on: whole heights, pixel row by pixel row. Whole numbers make every result
// exact, so neither order nor tiling can show.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "ilot/rasters.h"

namespace ilot {

// In scale units. Magnitudes below 2^30, but for the two ends: kNoHeight marks a pixel without points and is lower than
// every height; kAboveAll is what a marker holds where it says nothing.
using Height = std::int32_t;
constexpr Height kNoHeight = std::numeric_limits<Height>::min();
constexpr Height kAboveAll = std::numeric_limits<Height>::max();

// Fewer than 2^31 pixels, both sides at least 1 or the whole empty.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<Height> values = {};

  std::size_t size() const { return values.size(); }
};

inline Image filled_image(std::uint32_t width, std::uint32_t height, Height value) {
  return {width, height, std::vector<Height>(std::size_t{width} * height, value)};
}

// Labels from 1 to count, in the order of their first pixels where a kernel numbers them; 0 = none.
struct PixelLabels {
  std::uint32_t width = 0, height = 0;
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of = {};
};

}  // namespace ilot
