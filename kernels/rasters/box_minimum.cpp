// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/box_minimum.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace ilot {
namespace {

constexpr std::uint32_t kStrip = 64;  // columns worked on at a time

void least_of_two(const Height* __restrict a, const Height* __restrict b, Height* __restrict out, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out[i] = std::min(a[i], b[i]);
}

// Each value becomes the least of itself and the window - 1 behind it, `stride` apart: the window doubles with each
// pass, the last makes up what is missing. Those with less than a window behind them lose their meaning.
void lower_to_windows(std::vector<Height>& values, std::vector<Height>& scratch, std::size_t stride,
                      std::size_t window) {
  std::size_t size = values.size(), reached = 1;
  scratch.resize(size);
  const auto reach_on = [&](std::size_t more) {
    size -= more * stride;
    least_of_two(values.data(), values.data() + more * stride, scratch.data(), size);
    values.swap(scratch);
  };
  for (; 2 * reached <= window; reached *= 2) reach_on(reached);
  if (reached < window) reach_on(window - reached);
}

Height or_highest(Height v) {
  return v == kNoHeight ? kAboveAll : v;
}

Height or_missing(Height v) {
  return v == kAboveAll ? kNoHeight : v;
}

bool none_in(std::span<const Height> values) {
  Height least = kAboveAll;
  for (const Height v : values) least = std::min(least, v);
  return least == kAboveAll;
}

// Each row without the reach at its two ends; kAboveAll where there is nothing.
Image lowered_rows(const Image& image, std::size_t reach) {
  const std::size_t width = image.width - 2 * reach;
  Image out = filled_image(static_cast<std::uint32_t>(width), image.height, kAboveAll);
  std::vector<Height> line, scratch;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const Height* row = image.values.data() + std::size_t{y} * image.width;
    line.resize(image.width);
    std::transform(row, row + image.width, line.data(), or_highest);
    if (none_in(line)) continue;
    lower_to_windows(line, scratch, 1, 2 * reach + 1);
    std::copy_n(line.data(), width, out.values.data() + y * width);
  }
  return out;
}

Image lowered_columns(const Image& image, std::size_t reach) {
  const std::size_t height = image.height - 2 * reach;
  Image out = filled_image(image.width, static_cast<std::uint32_t>(height), kNoHeight);
  std::vector<Height> strip, scratch;
  for (std::uint32_t x = 0; x < image.width; x += kStrip) {
    const std::size_t width = std::min(kStrip, image.width - x);
    strip.resize(image.height * width);
    for (std::size_t y = 0; y < image.height; ++y)
      std::copy_n(image.values.data() + y * image.width + x, width, strip.data() + y * width);
    if (none_in(strip)) continue;
    lower_to_windows(strip, scratch, width, 2 * reach + 1);
    for (std::size_t y = 0; y < height; ++y)
      std::transform(strip.data() + y * width, strip.data() + (y + 1) * width, out.values.data() + y * image.width + x,
                     or_missing);
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
