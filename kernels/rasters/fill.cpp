// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/fill.h"

#include <cstdlib>

#include "kernels/rasters/flat_zones.h"
#include "kernels/rasters/settle.h"

namespace ilot {
namespace {

// f on the border of the image, above all inside.
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

// Of each region of missing pixels the lowest height around it; kNoHeight for those on the border of the image.
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

// One row or column of an image.
struct Line {
  std::size_t first, step, length;
  std::size_t at(std::size_t i) const { return first + i * step; }
};

// Lowers `out` to the straight lines over the short gaps of one line.
void bridge(const Image& image, const Line& line, const ShortGapsParams& params, std::vector<Height>& out) {
  std::size_t last = line.length;  // the last pixel with a height; none yet
  for (std::size_t i = 0; i < line.length; ++i) {
    const Height b = image.values[line.at(i)];
    if (b == kNoHeight) continue;
    if (last < i && i - last - 1 <= params.longest && i - last > 1) {
      const std::int64_t a = image.values[line.at(last)], steps = static_cast<std::int64_t>(i - last);
      if (std::abs(b - a) <= params.step)
        for (std::int64_t s = 1; s < steps; ++s) {
          Height& v = out[line.at(last + static_cast<std::size_t>(s))];
          v = std::min(v, static_cast<Height>((a * (steps - s) + b * s) / steps));
        }
    }
    last = i;
  }
}

}  // namespace

Image fill_holes(const Image& image, Adjacency adjacency) {
  if (image.size() == 0) return image;
  const PaddedFrame frame(image.width, image.height);
  const auto f = padded(image, kAboveAll);
  auto g = border_marker(frame, f);
  settle_by_erosion(frame, adjacency, f, g);
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

Image fill_short_gaps(const Image& image, const ShortGapsParams& params) {
  std::vector<Height> bridged(image.size(), kAboveAll);
  for (std::uint32_t y = 0; y < image.height; ++y)
    bridge(image, {std::size_t{y} * image.width, 1, image.width}, params, bridged);
  for (std::uint32_t x = 0; x < image.width; ++x) bridge(image, {x, image.width, image.height}, params, bridged);
  Image out = image;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (out.values[i] == kNoHeight && bridged[i] != kAboveAll) out.values[i] = bridged[i];
  return out;
}

}  // namespace ilot
