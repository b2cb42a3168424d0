// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/h_maxima.h"

#include <cassert>

#include "kernels/morphology/flat_zones.h"
#include "kernels/morphology/reconstruct.h"
#include "kernels/rasters/padded.h"

namespace ilot {
namespace {

// Tells for each zone whether none of its pixels has a higher neighbour.
std::vector<std::uint8_t> without_higher(const Image& image, const PixelLabels& zones, Adjacency adjacency) {
  const PaddedFrame frame(image.width, image.height);
  const auto heights = padded(image, kNoHeight);
  const auto steps = frame.steps();
  std::vector<std::uint8_t> top(std::size_t{zones.count} + 1, 1);
  std::size_t i = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x, ++i) {
      const auto p = static_cast<std::uint32_t>(frame.row(y) + x);
      unsigned higher = 0;
      for (std::size_t s = 0; s < step_count(adjacency); ++s) higher |= heights[p + steps[s]] > heights[p];
      if (higher != 0) top[zones.of[i]] = 0;
    }
  }
  return top;
}

}  // namespace

Image h_maxima(const Image& image, Height h, Adjacency adjacency) {
  assert(h >= 0);
  Image lowered = image;
  for (Height& v : lowered.values)
    if (v != kNoHeight) v -= h;
  return reconstruct_by_dilation(lowered, image, adjacency);
}

PixelLabels regional_maxima(const Image& image, Adjacency adjacency) {
  PixelLabels labels = flat_zones(image, 0, adjacency);
  const auto top = without_higher(image, labels, adjacency);
  std::vector<std::uint32_t> number(top.size(), 0);
  std::uint32_t maxima = 0;
  for (std::uint32_t zone = 1; zone <= labels.count; ++zone)
    if (top[zone] != 0) number[zone] = ++maxima;
  for (std::uint32_t& label : labels.of) label = number[label];
  labels.count = maxima;
  return labels;
}

}  // namespace ilot
