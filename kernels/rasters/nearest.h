// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

constexpr std::uint32_t kNoNearest = 0xffffffffu;

// Of each pixel the distance to its nearest one and which that is in one number: a nearer one is less, of equally near
// ones the first.
template <class Key>
struct NearestKeys {
  int bits = 0;                // of a pixel's number; the distance lies above them
  Key far = 0;                 // none within reach
  std::vector<Key> keys = {};  // row by row

  bool any(std::size_t i) const { return keys[i] < far; }
  std::uint32_t pixel(std::size_t i) const { return static_cast<std::uint32_t>(keys[i] & ((Key{1} << bits) - 1)); }
  std::uint32_t distance(std::size_t i) const { return static_cast<std::uint32_t>(keys[i] >> bits); }
};

// Of each pixel the nearest one that has a height, in steps from side to side, of equally near ones the first, row by
// row: itself where it has one. Pixels are those of the image with a margin around it in which there is none. Lines up
// and down, then rows to both sides (distance by sweeps: Rosenfeld and Pfaltz 1968). O(n), one key a pixel; the columns
// several at a time. `reach` below 2^31. Keys of 32 bits where those of the image fit (fit_nearest_keys), or of 64.
template <class Key>
NearestKeys<Key> nearest_keys(const Image& image, std::uint32_t reach, std::uint32_t margin);
extern template NearestKeys<std::int32_t> nearest_keys(const Image&, std::uint32_t, std::uint32_t);
extern template NearestKeys<std::int64_t> nearest_keys(const Image&, std::uint32_t, std::uint32_t);

inline bool fit_nearest_keys(std::size_t pixels, std::uint32_t reach) {
  return pixels == 0 || (std::uint64_t{reach} + 2) << std::bit_width(pixels - 1) < std::uint64_t{1} << 31;
}

// Calls use(keys) with the shorter ones that fit.
template <class Use>
auto with_nearest_keys(const Image& image, std::uint32_t reach, const Use& use) {
  return fit_nearest_keys(image.size(), reach) ? use(nearest_keys<std::int32_t>(image, reach, 0))
                                               : use(nearest_keys<std::int64_t>(image, reach, 0));
}

struct NearestPixels {
  std::vector<std::uint32_t> pixel;     // row by row; kNoNearest: none within reach
  std::vector<std::uint32_t> distance;  // steps from side to side; reach + 1 where there is none
};

// The same, taken apart: 8 bytes a pixel besides.
NearestPixels nearest_pixels(const Image& image, std::uint32_t reach);

}  // namespace ilot
