// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/building_mask.h"

#include <algorithm>

#include "kernels/rasters/box_minimum.h"

namespace ilot {
namespace {

constexpr std::uint32_t kLeastShareOf = 2;  // one in so many must be smooth
constexpr std::uint32_t kFewest = 4;        // smooth points in nine pixels

HighPoints around(const std::vector<HighPoints>& pixels, std::uint32_t width, std::uint32_t height, std::uint32_t x,
                  std::uint32_t y) {
  HighPoints sum;
  for (std::uint32_t v = y == 0 ? 0 : y - 1; v <= std::min(y + 1, height - 1); ++v) {
    for (std::uint32_t u = x == 0 ? 0 : x - 1; u <= std::min(x + 1, width - 1); ++u) {
      sum.high += pixels[std::size_t{v} * width + u].high;
      sum.smooth += pixels[std::size_t{v} * width + u].smooth;
    }
  }
  return sum;
}

}  // namespace

std::vector<std::uint8_t> building_mask(const std::vector<HighPoints>& pixels, std::uint32_t width,
                                        std::uint32_t height) {
  Image mask = filled_image(width, height, 0);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const HighPoints sum = around(pixels, width, height, x, y);
      mask.values[std::size_t{y} * width + x] = sum.smooth >= kFewest && kLeastShareOf * sum.smooth >= sum.high ? 1 : 0;
    }
  }
  Image eroded = box_minimum(mask, 1);
  for (Height& v : eroded.values) v = -v;
  const Image opened = box_minimum(eroded, 1);
  std::vector<std::uint8_t> result;
  for (const Height v : opened.values) result.push_back(v < 0 ? 1 : 0);
  return result;
}

}  // namespace ilot
