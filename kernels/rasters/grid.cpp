// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/grid.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "kernels/core/integers.h"
#include "kernels/rasters/pixel_at.h"

namespace ilot {
GridFrame frame_of(Points points, std::int64_t pixel) {
  assert(pixel >= 1);
  if (points.size == 0) return {0, 0, pixel, 0, 0};
  const auto [x0, x1] = std::minmax_element(points.x, points.x + points.size);
  const auto [y0, y1] = std::minmax_element(points.y, points.y + points.size);
  const auto cell = [&](float v) { return floor_divided(static_cast<std::int64_t>(v), pixel); };
  return {cell(*x0) * pixel, cell(*y0) * pixel, pixel, static_cast<std::uint32_t>(cell(*x1) - cell(*x0) + 1),
          static_cast<std::uint32_t>(cell(*y1) - cell(*y0) + 1)};
}

void pixels_of(Points points, const GridFrame& frame, std::span<std::uint32_t> out) {
  assert(out.size() == points.size && frame.size() < kNoPixel);
  const PixelAt pixel_at(frame);
  for (std::size_t i = 0; i < points.size; ++i) out[i] = pixel_at(points.x[i], points.y[i]);
}

GridHeights grid_heights(Points points, const GridFrame& frame) {
  assert(frame.size() < kNoPixel);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  GridHeights grid{std::vector<std::uint32_t>(frame.size(), 0), std::vector<float>(frame.size(), kInfinity),
                   std::vector<float>(frame.size(), -kInfinity)};
  const PixelAt pixel_at(frame);
  for (std::size_t i = 0; i < points.size; ++i) {
    const std::uint32_t pixel = pixel_at(points.x[i], points.y[i]);
    if (pixel == kNoPixel) continue;
    ++grid.count[pixel];
    grid.low[pixel] = std::min(grid.low[pixel], points.z[i]);
    grid.high[pixel] = std::max(grid.high[pixel], points.z[i]);
  }
  return grid;
}

void merge(GridHeights& into, const GridHeights& from) {
  assert(into.count.size() == from.count.size());
  for (std::size_t i = 0; i < into.count.size(); ++i) {
    into.count[i] += from.count[i];
    into.low[i] = std::min(into.low[i], from.low[i]);
    into.high[i] = std::max(into.high[i], from.high[i]);
  }
}

}  // namespace ilot
