// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

constexpr std::uint32_t kNoNearest = 0xffffffffu;

// For each pixel one number that combines the distance to its nearest pixel and the number of that pixel. A nearer
// pixel gives a smaller key. Of equally near pixels the first one counts.
template <class Key>
struct NearestKeys {
  int bits = 0;                // of the number of a pixel; the bits above them are the distance
  Key far = 0;                 // keys from this value on: none within reach
  std::vector<Key> keys = {};  // row by row

  bool any(std::size_t i) const { return keys[i] < far; }
  std::uint32_t pixel(std::size_t i) const { return static_cast<std::uint32_t>(keys[i] & ((Key{1} << bits) - 1)); }
  std::uint32_t distance(std::size_t i) const { return static_cast<std::uint32_t>(keys[i] >> bits); }
};

// Finds for each pixel the nearest one that has a height, in steps from side to side. Of equally near pixels the first
// one counts, row by row. A pixel with a height is its own nearest. The result has the pixels of the image and a margin
// around it that contains no height. It sweeps columns up and down, then rows in both directions (Rosenfeld and Pfaltz
// 1968). O(n), one key per pixel; several columns are processed at a time. `reach` is below 2^31. Keys have 32 bits
// where those of the image fit (fit_nearest_keys), otherwise 64.
template <class Key>
NearestKeys<Key> nearest_keys(const Image& image, std::uint32_t reach, std::uint32_t margin);
extern template NearestKeys<std::int32_t> nearest_keys(const Image&, std::uint32_t, std::uint32_t);
extern template NearestKeys<std::int64_t> nearest_keys(const Image&, std::uint32_t, std::uint32_t);

inline bool fit_nearest_keys(std::size_t pixels, std::uint32_t reach) {
  return pixels == 0 || (std::uint64_t{reach} + 2) << std::bit_width(pixels - 1) < std::uint64_t{1} << 31;
}

// Calls use(keys) with the shortest key type that fits.
template <class Use>
auto with_nearest_keys(const Image& image, std::uint32_t reach, const Use& use) {
  return fit_nearest_keys(image.size(), reach) ? use(nearest_keys<std::int32_t>(image, reach, 0))
                                               : use(nearest_keys<std::int64_t>(image, reach, 0));
}

struct NearestPixels {
  std::vector<std::uint32_t> pixel;     // row by row; kNoNearest: none within reach
  std::vector<std::uint32_t> distance;  // steps from side to side; reach + 1 where there is none
};

// The same as two separate arrays, with 8 more bytes per pixel.
NearestPixels nearest_pixels(const Image& image, std::uint32_t reach);

}  // namespace ilot
