// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/nearest.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace ilot {
namespace {

constexpr std::size_t kTogether = 4;  // rows swept at a time, so that none waits for the step before

// How a distance and a pixel lie in one number: whoever is nearer is less, then whoever comes first.
template <class Key>
struct Keys {
  Key step, far;  // far: one step beyond the reach, and more than any key within it
};

template <class Key>
void lower_row(const Key* __restrict other, Key* __restrict row, std::size_t width, Key step) {
  for (std::size_t x = 0; x < width; ++x) {
    const Key through = other[x] + step;
    row[x] = through < row[x] ? through : row[x];
  }
}

// The rows first, then each of them to both sides.
template <class Key, std::size_t kRows>
void sweep_rows(Key* rows, std::size_t width, const Keys<Key>& keys) {
  Key carried[kRows];
  const auto pass = [&](std::size_t x) {
    for (std::size_t r = 0; r < kRows; ++r) {
      Key& v = rows[r * width + x];
      const Key through = carried[r] + keys.step;
      v = carried[r] = through < v ? through : v;
    }
  };
  std::fill(carried, carried + kRows, keys.far);
  for (std::size_t x = 0; x < width; ++x) pass(x);
  std::fill(carried, carried + kRows, keys.far);
  for (std::size_t x = width; x-- > 0;) pass(x);
}

template <class Key>
std::vector<Key> swept(const Image& image, const Keys<Key>& keys) {
  const std::size_t width = image.width, height = image.height;
  std::vector<Key> key(image.size());
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = image.values[i] == kNoHeight ? keys.far : static_cast<Key>(i);
  for (std::size_t y = 1; y < height; ++y) lower_row(&key[(y - 1) * width], &key[y * width], width, keys.step);
  for (std::size_t y = height; y-- > 1;) lower_row(&key[y * width], &key[(y - 1) * width], width, keys.step);
  std::size_t y = 0;
  for (; y + kTogether <= height; y += kTogether) sweep_rows<Key, kTogether>(&key[y * width], width, keys);
  for (; y < height; ++y) sweep_rows<Key, 1>(&key[y * width], width, keys);
  return key;
}

template <class Key>
NearestPixels nearest_by(const Image& image, std::uint32_t reach, int bits) {
  const Keys<Key> keys{Key{1} << bits, (static_cast<Key>(reach) + 1) << bits};
  const std::vector<Key> key = swept(image, keys);
  NearestPixels out{std::vector<std::uint32_t>(key.size()), std::vector<std::uint32_t>(key.size())};
  for (std::size_t i = 0; i < key.size(); ++i) {
    out.pixel[i] = key[i] < keys.far ? static_cast<std::uint32_t>(key[i] & (keys.step - 1)) : kNoNearest;
    out.distance[i] = static_cast<std::uint32_t>(key[i] >> bits);
  }
  return out;
}

}  // namespace

NearestPixels nearest_pixels(const Image& image, std::uint32_t reach) {
  if (image.size() == 0) return {};
  const int bits = std::bit_width(image.size() - 1);
  const bool short_keys = (std::uint64_t{reach} + 2) << bits < std::uint64_t{1} << 31;
  return short_keys ? nearest_by<std::int32_t>(image, reach, bits) : nearest_by<std::int64_t>(image, reach, bits);
}

}  // namespace ilot
