// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/grid.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace ilot {
namespace {

std::int64_t floor_divided(std::int64_t a, std::int64_t b) {
  const std::int64_t q = a / b;
  return a % b < 0 ? q - 1 : q;
}

// Cell along an axis. Half a unit is added so that the true quotient keeps 2^-25 away from any whole number, more than
// the product can be off: offsets stay below 2^26, so truncation is exact for those that are not negative.
struct Axis {
  double from, per_unit;
  std::uint32_t cells;

  std::uint32_t cell(float v) const {
    const double steps = (static_cast<double>(v) - from + 0.5) * per_unit;
    return steps > 0 ? static_cast<std::uint32_t>(std::min(steps, 4e9)) : kNoPixel;
  }
};

std::uint32_t pixel_at(const Axis& x, const Axis& y, float px, float py) {
  const std::uint32_t column = x.cell(px), row = y.cell(py);
  return column < x.cells && row < y.cells ? row * x.cells + column : kNoPixel;
}

Axis axis_of(std::int64_t from, std::int64_t pixel, std::uint32_t cells) {
  return {static_cast<double>(from), 1 / static_cast<double>(pixel), cells};
}

}  // namespace

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
  const Axis x = axis_of(frame.x, frame.pixel, frame.width), y = axis_of(frame.y, frame.pixel, frame.height);
  for (std::size_t i = 0; i < points.size; ++i) out[i] = pixel_at(x, y, points.x[i], points.y[i]);
}

GridHeights grid_heights(Points points, const GridFrame& frame) {
  assert(frame.size() < kNoPixel);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  GridHeights grid{std::vector<std::uint32_t>(frame.size(), 0), std::vector<float>(frame.size(), kInfinity),
                   std::vector<float>(frame.size(), -kInfinity)};
  const Axis x = axis_of(frame.x, frame.pixel, frame.width), y = axis_of(frame.y, frame.pixel, frame.height);
  for (std::size_t i = 0; i < points.size; ++i) {
    const std::uint32_t pixel = pixel_at(x, y, points.x[i], points.y[i]);
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
