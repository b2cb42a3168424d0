// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/whole_fill.h"

#include <algorithm>

#include "kernels/morphology/flat_zones.h"
#include "kernels/morphology/reconstruct_in_place.h"

namespace ilot::test {
namespace {

// Returns f on the border of the image, and a value above all others inside.
std::vector<Height> border_marker(const PaddedFrame& frame, const std::vector<Height>& f) {
  std::vector<Height> g(f.size(), kAboveAll);
  const auto keep = [&](std::size_t i) { g[i] = f[i]; };
  for (std::uint32_t x = 0; x < frame.width; ++x) {
    keep(frame.row(0) + x);
    keep(frame.row(frame.height - 1) + x);
  }
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    keep(frame.row(y));
    keep(frame.row(y) + frame.width - 1);
  }
  return g;
}

// Returns for each region of missing pixels the lowest height around it, and kNoHeight for regions on the border of the
// image.
std::vector<Height> levels_around(const Image& image, const PixelLabels& missing) {
  const PaddedFrame frame(image.width, image.height);
  const auto heights = padded(image, kNoHeight);
  const auto steps = frame.steps();
  std::vector<Height> levels(missing.count + 1, kAboveAll);
  std::size_t i = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x, ++i) {
      const std::uint32_t region = missing.of[i];
      if (region == 0) continue;
      Height& level = levels[region];
      if (x == 0 || y == 0 || x + 1 == image.width || y + 1 == image.height) level = kNoHeight;
      const auto p = static_cast<std::uint32_t>(frame.row(y) + x);
      for (const std::uint32_t step : steps) {
        const Height h = heights[p + step];
        if (h != kNoHeight) level = std::min(level, h);
      }
    }
  }
  return levels;
}

}  // namespace

Image fill_holes(const Image& image, Adjacency adjacency) {
  if (image.size() == 0) return image;
  const PaddedFrame frame(image.width, image.height);
  const auto f = padded(image, kAboveAll);
  auto g = border_marker(frame, f);
  reconstruct_in_place(frame, adjacency, f, g);
  return {image.width, image.height, unpadded<Height>(frame, g)};
}

Image fill_missing(const Image& image) {
  Image absent{image.width, image.height, std::vector<Height>(image.size())};
  for (std::size_t i = 0; i < image.size(); ++i) absent.values[i] = image.values[i] == kNoHeight ? 0 : kNoHeight;
  const PixelLabels missing = flat_zones(absent, 0, Adjacency::eight);
  const std::vector<Height> levels = levels_around(image, missing);
  Image out = image;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (missing.of[i] != 0) out.values[i] = levels[missing.of[i]];
  return out;
}

}  // namespace ilot::test
