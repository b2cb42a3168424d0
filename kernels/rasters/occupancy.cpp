// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/occupancy.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace ilot {
namespace {

void or_of_two(const Occupancy* __restrict a, const Occupancy* __restrict b, Occupancy* __restrict out,
               std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out[i] = a[i] | b[i];
}

// Combines each value with the window - 1 values behind it, `stride` apart. Values with fewer than that many behind
// them become meaningless, but keep their places.
void join_windows(std::vector<Occupancy>& values, std::vector<Occupancy>& scratch, std::size_t stride,
                  std::size_t window) {
  scratch.resize(values.size());
  std::size_t size = values.size(), reached = 1;
  const auto reach_on = [&](std::size_t more) {
    size -= std::min(size, more * stride);
    or_of_two(values.data(), values.data() + more * stride, scratch.data(), size);
    values.swap(scratch);
  };
  for (; 2 * reached <= window; reached *= 2) reach_on(reached);
  if (reached < window) reach_on(window - reached);
}

// Returns the image with an empty margin.
std::vector<Occupancy> with_margin(std::span<const Occupancy> image, std::size_t width, std::size_t height,
                                   std::size_t margin) {
  const std::size_t row = width + 2 * margin;
  std::vector<Occupancy> out(row * (height + 2 * margin), 0);
  for (std::size_t y = 0; y < height; ++y)
    std::copy_n(image.data() + y * width, width, out.data() + (y + margin) * row + margin);
  return out;
}

}  // namespace

std::vector<Occupancy> free_bins(std::span<const Occupancy> image, std::uint32_t width, std::uint32_t height,
                                 const PixelRing& ring) {
  assert(image.size() == std::size_t{width} * height && ring.within < ring.reach);
  const std::size_t inner = ring.within, reach = ring.reach, band = reach - inner, row = width + 2 * reach;
  std::vector<Occupancy> across = with_margin(image, width, height, reach), beside = across, scratch;
  join_windows(across, scratch, 1, 2 * reach + 1);  // the bands above and below, over their whole width
  join_windows(across, scratch, row, band);
  join_windows(beside, scratch, 1, band);  // those left and right, between them
  join_windows(beside, scratch, row, 2 * inner + 1);
  std::vector<Occupancy> out(image.size());
  for (std::size_t y = 0; y < height; ++y) {
    const Occupancy *below = across.data() + y * row, *above = below + (reach + inner + 1) * row,
                    *left = beside.data() + (y + band) * row, *right = left + reach + inner + 1;
    for (std::size_t x = 0; x < width; ++x)
      out[y * width + x] = image[y * width + x] & ~(below[x] | above[x] | left[x] | right[x]);
  }
  return out;
}

BinRun longest_run(Occupancy bins) {
  BinRun best;
  for (std::uint32_t from = 0; bins != 0;) {
    const auto skipped = static_cast<std::uint32_t>(std::countr_zero(bins));
    bins >>= skipped;
    from += skipped;
    const auto length = static_cast<std::uint32_t>(std::countr_one(bins));
    if (length > best.length) best = {from, length};
    bins = length == 32 ? 0 : bins >> length;
    from += length;
  }
  return best;
}

}  // namespace ilot
