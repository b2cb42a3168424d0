// SPDX-License-Identifier: Apache-2.0
// The range image of points that are all in memory. This code is slow and easy to read.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/rasters/image.h"

namespace ilot::test {

struct RangeImage {
  Image range;                          // highest z of each pixel; kNoHeight where there is no point
  std::vector<std::uint32_t> pixel_of;  // pixel of each point
};

// Pixels begin at multiples of their side.
inline RangeImage range_image(Points points, double side) {
  const auto cell = [side](float v) { return static_cast<std::int64_t>(std::floor(static_cast<double>(v) / side)); };
  const auto [x0, x1] = std::minmax_element(points.x, points.x + points.size);
  const auto [y0, y1] = std::minmax_element(points.y, points.y + points.size);
  const auto width = static_cast<std::uint32_t>(cell(*x1) - cell(*x0) + 1);
  const auto height = static_cast<std::uint32_t>(cell(*y1) - cell(*y0) + 1);
  RangeImage image{filled_image(width, height, kNoHeight), std::vector<std::uint32_t>(points.size)};
  for (std::size_t i = 0; i < points.size; ++i) {
    const auto at = static_cast<std::uint32_t>((cell(points.y[i]) - cell(*y0)) * width + cell(points.x[i]) - cell(*x0));
    image.pixel_of[i] = at;
    image.range.values[at] = std::max(image.range.values[at], static_cast<Height>(points.z[i]));
  }
  return image;
}

}  // namespace ilot::test
