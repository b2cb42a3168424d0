// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/outward_drops.h"

#include <cassert>

#include "kernels/rasters/where.h"

namespace ilot {
namespace {

// Whether both have a height and differ by more than lambda. Differences of heights fit the type. Other differences are
// ignored.
int steep(Height a, Height b, Height lambda) {
  const auto step = static_cast<Height>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
  return ((step > lambda) | (step < -lambda)) & (a != kNoHeight) & (b != kNoHeight);
}

}  // namespace

std::vector<std::int32_t> outward_drops(const Image& image, const PixelLabels& zones, Height lambda) {
  assert(zones.of.size() == image.size() && lambda >= 0);
  std::vector<std::int32_t> drops(std::size_t{zones.count} + 1, 0);
  const auto count = [&](std::size_t a, std::size_t b) {
    const std::int32_t step = outward_drop(image.values[a], image.values[b], lambda);
    if (step == 0) return;
    drops[zones.of[a]] += step;
    drops[zones.of[b]] -= step;
  };
  const std::size_t w = image.width;
  for (std::size_t y = 0; y < image.height; ++y) {
    const bool last = y + 1 == image.height;
    const auto count_at = [&](std::size_t x) {
      const std::size_t i = y * w + x;
      if (x + 1 < w) count(i, i + 1);
      if (last) return;
      count(i, i + w);
      if (x > 0) count(i, i + w - 1);
      if (x + 1 < w) count(i, i + w + 1);
    };
    count_at(0);
    const Height* row = image.values.data() + y * w + 1;
    const Height* below = last ? row : row + w;
    if (w > 2)
      for_each_where(
          w - 2,
          [&](std::size_t x) {
            const Height v = row[x];
            return steep(v, row[x + 1], lambda) | steep(v, *(below + x - 1), lambda) | steep(v, below[x], lambda) |
                   steep(v, below[x + 1], lambda);
          },
          [&](std::size_t x) { count_at(x + 1); });
    if (w > 1) count_at(w - 1);
  }
  return drops;
}

}  // namespace ilot
