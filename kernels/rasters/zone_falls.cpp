// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/zone_falls.h"

#include <cassert>

namespace ilot {

std::vector<std::int32_t> zone_falls(const Image& image, const PixelLabels& zones, Height lambda) {
  assert(zones.of.size() == image.size());
  std::vector<std::int32_t> falls(std::size_t{zones.count} + 1, 0);
  const auto count = [&](std::size_t a, std::size_t b) {
    const std::int32_t step = fall(image.values[a], image.values[b], lambda);
    if (step == 0) return;
    falls[zones.of[a]] += step;
    falls[zones.of[b]] -= step;
  };
  const std::size_t w = image.width;
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < w; ++x) {
      const std::size_t i = y * w + x;
      if (x + 1 < w) count(i, i + 1);
      if (y + 1 == image.height) continue;
      count(i, i + w);
      if (x > 0) count(i, i + w - 1);
      if (x + 1 < w) count(i, i + w + 1);
    }
  return falls;
}

}  // namespace ilot
