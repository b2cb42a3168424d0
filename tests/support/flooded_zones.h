// SPDX-License-Identifier: Apache-2.0
// Zones of an image found by flooding from pixel to pixel. This is the oracle for all code that finds zones from runs
// and tiles.
#pragma once
#include <cstdlib>
#include <functional>

#include "tests/support/small_images.h"

namespace ilot::test {

// Returns the regions of the pixels for which `in` is true. Neighbours are in one region if `joined` is true for them.
// Regions are numbered by their first pixel.
inline PixelLabels flooded(std::uint32_t width, std::uint32_t height, Adjacency adjacency,
                           const std::function<bool(std::size_t)>& in,
                           const std::function<bool(std::size_t, std::size_t)>& joined) {
  PixelLabels labels{width, height, 0, std::vector<std::uint32_t>(std::size_t{width} * height, 0)};
  for (std::size_t start = 0; start < labels.of.size(); ++start) {
    if (!in(start) || labels.of[start] != 0) continue;
    std::vector<std::size_t> open{start};
    labels.of[start] = ++labels.count;
    while (!open.empty()) {
      const std::size_t p = open.back();
      open.pop_back();
      for (const std::size_t q : neighbours_of(width, height, p, adjacency)) {
        if (!in(q) || labels.of[q] != 0 || !joined(p, q)) continue;
        labels.of[q] = labels.count;
        open.push_back(q);
      }
    }
  }
  return labels;
}

inline PixelLabels flooded_zones(const Image& image, Height lambda, Adjacency adjacency) {
  return flooded(
      image.width, image.height, adjacency, [&](std::size_t p) { return image.values[p] != kNoHeight; },
      [&](std::size_t p, std::size_t q) {
        return std::llabs(std::int64_t{image.values[p]} - image.values[q]) <= lambda;
      });
}

}  // namespace ilot::test
