// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/box_minimum.h"

#include <algorithm>

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

void lower_rows(Image& image, std::size_t reach) {
  std::vector<Height> line, scratch;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    Height* row = image.values.data() + std::size_t{y} * image.width;
    line.assign(image.width + 2 * reach, kAboveAll);
    std::transform(row, row + image.width, line.data() + reach, or_highest);
    lower_to_windows(line, scratch, 1, 2 * reach + 1);
    std::copy_n(line.data(), image.width, row);
  }
}

void lower_columns(Image& image, std::size_t reach) {
  std::vector<Height> strip, scratch;
  for (std::uint32_t x = 0; x < image.width; x += kStrip) {
    const std::size_t width = std::min(kStrip, image.width - x);
    strip.assign((image.height + 2 * reach) * width, kAboveAll);
    Height* column = image.values.data() + x;
    for (std::size_t y = 0; y < image.height; ++y)
      std::copy_n(column + y * image.width, width, strip.data() + (y + reach) * width);
    lower_to_windows(strip, scratch, width, 2 * reach + 1);
    for (std::size_t y = 0; y < image.height; ++y)
      std::transform(strip.data() + y * width, strip.data() + (y + 1) * width, column + y * image.width, or_missing);
  }
}

}  // namespace

Image box_minimum(const Image& image, std::uint32_t reach) {
  Image out = image;
  lower_rows(out, std::min(reach, image.width));
  lower_columns(out, std::min(reach, image.height));
  return out;
}

}  // namespace ilot
