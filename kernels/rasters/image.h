// SPDX-License-Identifier: Apache-2.0
// The plain data that raster kernels work on: integer heights, pixel row by pixel row. Integers make every result
// exact, so neither order nor tiles matter.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "ilot/rasters.h"

namespace ilot {

// A height in scale units. Magnitudes are below 2^30, except for two values. kNoHeight marks a pixel without points and
// is lower than every height. kAboveAll is the value of a marker where it sets no limit.
using Height = std::int32_t;
constexpr Height kNoHeight = std::numeric_limits<Height>::min();
constexpr Height kAboveAll = std::numeric_limits<Height>::max();

// The value of a pixel where the lowest is sought: kNoHeight becomes the highest value.
constexpr Height or_highest(Height v) {
  return v == kNoHeight ? kAboveAll : v;
}

// There are fewer than 2^31 pixels. Both sides are at least 1, or the whole image is empty.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<Height> values = {};

  std::size_t size() const { return values.size(); }
};

inline Image filled_image(std::uint32_t width, std::uint32_t height, Height value) {
  return {width, height, std::vector<Height>(std::size_t{width} * height, value)};
}

// Labels from 1 to count. Where a kernel numbers them, they are in the order of their first pixels. 0 means no label.
struct PixelLabels {
  std::uint32_t width = 0, height = 0;
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of = {};
};

}  // namespace ilot
