// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels: a copy of an image with a border of one pixel, so that neighbours need no test of
// bounds.
#pragma once
#include <algorithm>
#include <array>
#include <cassert>
#include <span>

#include "kernels/rasters/image.h"

namespace ilot {

struct PaddedFrame {
  std::uint32_t width, height, stride;

  PaddedFrame(std::uint32_t w, std::uint32_t h) : width(w), height(h), stride(w + 2) {
    assert(std::size_t{stride} * (h + 2) < (std::size_t{1} << 32));
  }
  std::size_t size() const { return std::size_t{stride} * (height + 2); }
  std::size_t row(std::uint32_t y) const { return std::size_t{stride} * (y + 1) + 1; }  // of its first pixel

  // Steps to the neighbours. For four neighbours use the first four. They are added to a pixel modulo 2^32.
  std::array<std::uint32_t, 8> steps() const {
    return {0u - stride, 0u - 1u, 1u, stride, 0u - stride - 1u, 0u - stride + 1u, stride - 1u, stride + 1u};
  }
};

inline std::size_t step_count(Adjacency adjacency) {
  return adjacency == Adjacency::four ? 4 : 8;
}

template <typename T>
std::vector<T> padded(std::uint32_t width, std::uint32_t height, std::span<const T> values, T border) {
  const PaddedFrame frame(width, height);
  std::vector<T> out(frame.size(), border);
  for (std::uint32_t y = 0; y < height; ++y)
    std::copy_n(values.data() + std::size_t{width} * y, width, out.data() + frame.row(y));
  return out;
}

inline std::vector<Height> padded(const Image& image, Height border) {
  return padded<Height>(image.width, image.height, image.values, border);
}

template <typename T>
std::vector<T> unpadded(const PaddedFrame& frame, std::span<const T> values) {
  std::vector<T> out(std::size_t{frame.width} * frame.height);
  for (std::uint32_t y = 0; y < frame.height; ++y)
    std::copy_n(values.data() + frame.row(y), frame.width, out.data() + std::size_t{frame.width} * y);
  return out;
}

}  // namespace ilot
