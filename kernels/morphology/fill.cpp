// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/fill.h"

#include <cstdlib>

#include "kernels/rasters/where.h"

namespace ilot {
namespace {

// Writes the straight line over a gap to `out` where it is lower than the value there. `last` and `next` are the
// heights at the two ends. Pixels are `by` apart, and the gap has `length` pixels.
void bridge(Height last, Height next, std::size_t first, std::size_t by, std::uint32_t length,
            const ShortGapsParams& params, std::vector<Height>& out) {
  const std::int64_t a = last, b = next, steps = std::int64_t{length} + 1;
  if (length > params.longest || std::abs(b - a) > params.step) return;
  for (std::int64_t s = 1; s < steps; ++s) {
    Height& v = out[first + static_cast<std::size_t>(s - 1) * by];
    // This is exact as a division of integers: a quotient that is not an integer is farther from any integer than
    // 2^-20.
    const auto on_line = static_cast<Height>(static_cast<double>(a * (steps - s) + b * s) / static_cast<double>(steps));
    v = v == kNoHeight ? on_line : std::min(v, on_line);
  }
}

// Finds where heights end and begin along a row.
void bridge_row(const Image& image, std::uint32_t y, const ShortGapsParams& params, std::vector<Height>& out) {
  const std::size_t row = std::size_t{y} * image.width;
  const Height* values = image.values.data() + row;
  std::size_t from = 0;  // first pixel of the gap; 0: none yet, because a gap begins behind a height
  for_each_where(
      image.width - 1, [&](std::size_t x) { return (values[x] == kNoHeight) ^ (values[x + 1] == kNoHeight); },
      [&](std::size_t x) {
        if (values[x] != kNoHeight)
          from = x + 1;
        else if (from != 0)
          bridge(values[from - 1], values[x + 1], row + from, 1, static_cast<std::uint32_t>(x + 1 - from), params, out);
      });
}

// Does the same along all columns, row by row. `from` has the first row of the gap of each column, 0: none yet.
void bridge_columns(const Image& image, std::uint32_t y, const ShortGapsParams& params,
                    std::vector<std::uint32_t>& from, std::vector<Height>& out) {
  const std::size_t width = image.width;
  const Height *below = image.values.data() + y * width, *above = below - width;
  for_each_where(
      width, [&](std::size_t x) { return (above[x] == kNoHeight) ^ (below[x] == kNoHeight); },
      [&](std::size_t x) {
        if (above[x] != kNoHeight)
          from[x] = y;
        else if (from[x] != 0)
          bridge(image.values[(from[x] - 1) * width + x], below[x], from[x] * width + x, width, y - from[x], params,
                 out);
      });
}

}  // namespace

Image fill_short_gaps(const Image& image, const ShortGapsParams& params) {
  Image out = image;
  std::vector<std::uint32_t> from(image.width, 0);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    bridge_row(image, y, params, out.values);
    if (y > 0) bridge_columns(image, y, params, from, out.values);
  }
  return out;
}

}  // namespace ilot
