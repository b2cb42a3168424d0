// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/range_image.h"

#include <algorithm>
#include <cassert>

#include "kernels/core/integers.h"
#include "kernels/rasters/pixel_at.h"

namespace ilot {
namespace {

void add_pixel(RangeImage& into, std::size_t at, Height range, std::uint32_t points) {
  into.range.values[at] = std::max(into.range.values[at], range);
  into.accumulation[at] += points;
}

// Columns (or rows) of `from` that lie on `into`, and where the first of them lies there.
struct Overlap {
  std::int64_t first, end, shift;
};

Overlap overlap(std::int64_t into_from, std::uint32_t into_cells, std::int64_t from_from, std::uint32_t from_cells,
                std::int64_t pixel) {
  assert((from_from - into_from) % pixel == 0);
  const std::int64_t shift = (from_from - into_from) / pixel;
  return {std::max<std::int64_t>(0, -shift), std::min<std::int64_t>(from_cells, into_cells - shift), shift};
}

}  // namespace

RangeImage empty_range_image(const GridFrame& frame) {
  assert(frame.size() < kNoPixel);
  return {frame, filled_image(frame.width, frame.height, kNoHeight), std::vector<std::uint32_t>(frame.size(), 0)};
}

void add_points(RangeImage& image, Points points) {
  const PixelAt pixel_at(image.frame);
  for (std::size_t i = 0; i < points.size; ++i) {
    const std::uint32_t pixel = pixel_at(points.x[i], points.y[i]);
    if (pixel != kNoPixel) add_pixel(image, pixel, static_cast<Height>(points.z[i]), 1);
  }
}

RangeImage range_image(Points points, const GridFrame& frame) {
  RangeImage image = empty_range_image(frame);
  add_points(image, points);
  return image;
}

void merge(RangeImage& into, const RangeImage& from) {
  assert(into.frame.pixel == from.frame.pixel);
  const GridFrame &a = into.frame, &b = from.frame;
  const Overlap x = overlap(a.x, a.width, b.x, b.width, a.pixel), y = overlap(a.y, a.height, b.y, b.height, a.pixel);
  for (std::int64_t row = y.first; row < y.end; ++row) {
    const std::int64_t source = row * b.width, target = (row + y.shift) * a.width + x.shift;
    for (std::int64_t column = x.first; column < x.end; ++column) {
      const auto i = static_cast<std::size_t>(source + column);
      add_pixel(into, static_cast<std::size_t>(target + column), from.range.values[i], from.accumulation[i]);
    }
  }
}

RangeImage coarser(const RangeImage& image, std::uint32_t factor) {
  assert(factor >= 1);
  const GridFrame& fine = image.frame;
  if (fine.size() == 0) return empty_range_image({0, 0, fine.pixel * factor, 0, 0});
  const std::int64_t pixel = fine.pixel * factor;
  const auto cells = [&](std::int64_t from, std::uint32_t count) {
    const std::int64_t first = floor_divided(from, pixel), last = floor_divided(from + (count - 1) * fine.pixel, pixel);
    return static_cast<std::uint32_t>(last - first + 1);
  };
  const GridFrame frame{floor_divided(fine.x, pixel) * pixel, floor_divided(fine.y, pixel) * pixel, pixel,
                        cells(fine.x, fine.width), cells(fine.y, fine.height)};
  RangeImage out = empty_range_image(frame);
  const auto left = static_cast<std::uint32_t>((fine.x - frame.x) / fine.pixel);
  const auto below = static_cast<std::uint32_t>((fine.y - frame.y) / fine.pixel);
  std::size_t i = 0;
  for (std::uint32_t y = 0; y < fine.height; ++y) {
    const std::size_t row = std::size_t{(y + below) / factor} * frame.width;
    for (std::uint32_t x = 0; x < fine.width; ++x, ++i)
      add_pixel(out, row + (x + left) / factor, image.range.values[i], image.accumulation[i]);
  }
  return out;
}

}  // namespace ilot
