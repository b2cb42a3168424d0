// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/box_minimum.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "kernels/rasters/rows_body.h"

namespace ilot {
namespace {

constexpr std::size_t kStrip = 64;  // columns worked on at a time

void least_of_two(const Height* a, const Height* b, Height* out, std::size_t size) {
  simd::kRasterRows.best().least_of_two({a, b, out, size});
}

// Sets each value to the minimum of itself and the window - 1 values behind it. The window doubles with each pass, and
// the last pass adds what is missing. Values with fewer than that many behind them become meaningless.
void lower_to_windows(std::vector<Height>& values, std::vector<Height>& scratch, std::size_t window) {
  std::size_t size = values.size(), reached = 1;
  scratch.resize(size);
  const auto reach_on = [&](std::size_t more) {
    size -= more;
    least_of_two(values.data(), values.data() + more, scratch.data(), size);
    values.swap(scratch);
  };
  for (; 2 * reached <= window; reached *= 2) reach_on(reached);
  if (reached < window) reach_on(window - reached);
}

Height or_missing(Height v) {
  return v == kAboveAll ? kNoHeight : v;
}

bool none_in(std::span<const Height> values) {
  Height least = kAboveAll;
  for (const Height v : values) least = std::min(least, v);
  return least == kAboveAll;
}

// Lowers each row, without the reach at its two ends. It is kAboveAll where there is nothing.
Image lowered_rows(const Image& image, std::size_t reach) {
  const std::size_t width = image.width - 2 * reach;
  Image out = filled_image(static_cast<std::uint32_t>(width), image.height, kAboveAll);
  std::vector<Height> line, scratch;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const Height* row = image.values.data() + std::size_t{y} * image.width;
    line.resize(image.width);
    std::transform(row, row + image.width, line.data(), or_highest);
    if (none_in(line)) continue;
    lower_to_windows(line, scratch, 2 * reach + 1);
    std::copy_n(line.data(), width, out.values.data() + y * width);
  }
  return out;
}

// Lowers one strip of columns, a row of the strip at a time. A window goes from a row to the end of its block of as
// many rows (`ends`, of a whole block) and on from the beginning of the next block (van Herk 1992).
void lower_strip(const Image& image, std::size_t x, std::size_t width, std::size_t window, std::vector<Height>& ends,
                 Image& out) {
  const auto row = [&](std::size_t y) { return image.values.data() + y * image.width + x; };
  const auto end = [&](std::size_t j) { return ends.data() + j * kStrip; };
  for (std::size_t block = 0; block < out.height; block += window) {
    std::copy_n(row(block + window - 1), width, end(window - 1));
    for (std::size_t j = window - 1; j-- > 0;) least_of_two(row(block + j), end(j + 1), end(j), width);
    Height begun[2][kStrip];
    std::fill_n(begun[0], width, kAboveAll);
    for (std::size_t j = 0; j < std::min<std::size_t>(window, out.height - block); ++j) {
      Height *before = begun[j % 2], *now = begun[(j + 1) % 2];
      if (j == 0)
        std::copy_n(before, width, now);
      else
        least_of_two(before, row(block + j + window - 1), now, width);
      Height* to = out.values.data() + (block + j) * out.width + x;
      least_of_two(now, end(j), to, width);
      std::transform(to, to + width, to, or_missing);
    }
  }
}

Image lowered_columns(const Image& image, std::size_t reach) {
  Image out = filled_image(image.width, static_cast<std::uint32_t>(image.height - 2 * reach), kNoHeight);
  std::vector<Height> ends((2 * reach + 1) * kStrip);
  for (std::size_t x = 0; x < image.width; x += kStrip) {
    const std::size_t width = std::min<std::size_t>(kStrip, image.width - x);
    Height least = kAboveAll;
    for (std::size_t y = 0; y < image.height; ++y)
      for (std::size_t i = 0; i < width; ++i) least = std::min(least, image.values[y * image.width + x + i]);
    if (least != kAboveAll) lower_strip(image, x, width, 2 * reach + 1, ends, out);
  }
  return out;
}

Image with_margin(const Image& image, std::uint32_t margin) {
  Image out = filled_image(image.width + 2 * margin, image.height + 2 * margin, kNoHeight);
  for (std::uint32_t y = 0; y < image.height; ++y)
    std::copy_n(image.values.data() + std::size_t{y} * image.width, image.width,
                out.values.data() + std::size_t{y + margin} * out.width + margin);
  return out;
}

}  // namespace

Image box_minimum_within(const Image& image, std::uint32_t reach) {
  assert(image.width > 2 * reach && image.height > 2 * reach);
  return lowered_columns(lowered_rows(image, reach), reach);
}

Image box_minimum(const Image& image, std::uint32_t reach) {
  if (image.size() == 0) return image;
  return box_minimum_within(with_margin(image, std::min(reach, std::max(image.width, image.height))),
                            std::min(reach, std::max(image.width, image.height)));
}

}  // namespace ilot
