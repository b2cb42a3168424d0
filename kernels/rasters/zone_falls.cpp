// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/zone_falls.h"

#include <cassert>

#include "kernels/rasters/where.h"

namespace ilot {
namespace {

// Whether both have a height and differ by more than lambda; differences of heights fit, others count for nothing.
int steep(Height a, Height b, Height lambda) {
  const auto step = static_cast<Height>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
  return ((step > lambda) | (step < -lambda)) & (a != kNoHeight) & (b != kNoHeight);
}

}  // namespace

std::vector<std::int32_t> zone_falls(const Image& image, const PixelLabels& zones, Height lambda) {
  assert(zones.of.size() == image.size() && lambda >= 0);
  std::vector<std::int32_t> falls(std::size_t{zones.count} + 1, 0);
  // Steps from each pixel of a row to the one `by` on, of which there are `size` from the first.
  const auto count = [&](std::size_t first, std::size_t by, std::size_t size) {
    const Height *a = image.values.data() + first, *b = a + by;
    const std::uint32_t *zone = zones.of.data() + first, *beside = zone + by;
    for_each_where(
        size, [&](std::size_t i) { return steep(a[i], b[i], lambda); },
        [&](std::size_t i) {
          const std::int32_t step = a[i] > b[i] ? 1 : -1;
          falls[zone[i]] += step;
          falls[beside[i]] -= step;
        });
  };
  const std::size_t w = image.width;
  for (std::size_t y = 0; y < image.height; ++y) {
    count(y * w, 1, w - 1);
    if (y + 1 == image.height) break;
    count(y * w, w, w);
    count(y * w, w + 1, w - 1);
    count(y * w + 1, w - 1, w - 1);
  }
  return falls;
}

}  // namespace ilot
