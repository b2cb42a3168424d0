// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/nearest.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "kernels/rasters/rows_body.h"

namespace ilot {
namespace {

constexpr std::size_t kTogether = 4;  // rows swept at a time, so that none waits for the step before

void lower_row(const std::int32_t* other, std::int32_t* row, std::size_t width, std::int32_t step) {
  simd::kRasterRows.best().lower_by_step({other, row, width, step});
}

void lower_row(const std::int64_t* __restrict other, std::int64_t* __restrict row, std::size_t width,
               std::int64_t step) {
  for (std::size_t x = 0; x < width; ++x) row[x] = std::min(row[x], other[x] + step);
}

// Sweeps the rows first, then each of them in both directions, from `from` to `to`.
template <class Key, std::size_t kRows>
void sweep_rows(Key* rows, std::size_t width, std::size_t from, std::size_t to, Key step, Key far) {
  Key carried[kRows];
  const auto pass = [&](std::size_t x) {
    for (std::size_t r = 0; r < kRows; ++r) {
      Key& v = rows[r * width + x];
      const Key through = carried[r] + step;
      v = carried[r] = through < v ? through : v;
    }
  };
  std::fill(carried, carried + kRows, far);
  for (std::size_t x = from; x < to; ++x) pass(x);
  std::fill(carried, carried + kRows, far);
  for (std::size_t x = to; x-- > from;) pass(x);
}

// Does the same where a pixel is in reach: only up to the reach before the first and behind the last pixel that is near
// one.
template <class Key, std::size_t kRows>
void sweep_near(Key* rows, std::size_t width, std::size_t reach, Key step, Key far) {
  const auto near = [&](std::size_t x) {
    bool any = false;
    for (std::size_t r = 0; r < kRows; ++r) any |= rows[r * width + x] < far;
    return any;
  };
  std::size_t first = 0, last = width;
  while (first < width && !near(first)) ++first;
  if (first == width) return;
  while (!near(last - 1)) --last;
  sweep_rows<Key, kRows>(rows, width, first - std::min(first, reach), last + std::min(width - last, reach), step, far);
}

template <class Key>
void mark_pixels(const Image& image, std::uint32_t margin, NearestKeys<Key>& out) {
  const std::size_t width = image.width + 2 * std::size_t{margin};
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const Height* __restrict from = image.values.data() + std::size_t{y} * image.width;
    const std::size_t first = (std::size_t{y} + margin) * width + margin;
    Key* __restrict to = out.keys.data() + first;
    for (std::size_t x = 0; x < image.width; ++x) to[x] = from[x] == kNoHeight ? out.far : static_cast<Key>(first + x);
  }
}

}  // namespace

template <class Key>
NearestKeys<Key> nearest_keys(const Image& image, std::uint32_t reach, std::uint32_t margin) {
  if (image.size() == 0) return {};
  const std::size_t width = image.width + 2 * std::size_t{margin}, height = image.height + 2 * std::size_t{margin};
  NearestKeys<Key> out;
  out.bits = std::bit_width(width * height - 1);
  const Key step = Key{1} << out.bits;
  out.far = (static_cast<Key>(reach) + 1) << out.bits;
  out.keys.assign(width * height, out.far);
  mark_pixels(image, margin, out);
  Key* keys = out.keys.data();
  for (std::size_t y = 1; y < height; ++y) lower_row(keys + (y - 1) * width, keys + y * width, width, step);
  for (std::size_t y = height; y-- > 1;) lower_row(keys + y * width, keys + (y - 1) * width, width, step);
  std::size_t y = 0;
  for (; y + kTogether <= height; y += kTogether)
    sweep_near<Key, kTogether>(keys + y * width, width, reach, step, out.far);
  for (; y < height; ++y) sweep_near<Key, 1>(keys + y * width, width, reach, step, out.far);
  return out;
}

template NearestKeys<std::int32_t> nearest_keys(const Image&, std::uint32_t, std::uint32_t);
template NearestKeys<std::int64_t> nearest_keys(const Image&, std::uint32_t, std::uint32_t);

NearestPixels nearest_pixels(const Image& image, std::uint32_t reach) {
  return with_nearest_keys(image, reach, [](const auto& keys) {
    NearestPixels out{std::vector<std::uint32_t>(keys.keys.size()), std::vector<std::uint32_t>(keys.keys.size())};
    for (std::size_t i = 0; i < keys.keys.size(); ++i) {
      out.pixel[i] = keys.any(i) ? keys.pixel(i) : kNoNearest;
      out.distance[i] = keys.distance(i);
    }
    return out;
  });
}

}  // namespace ilot
