// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/gradient.h"

#include "kernels/rasters/padded.h"

namespace ilot {
namespace {

template <Adjacency kAdjacency>
void gradient_row(const Height* row, std::size_t stride, std::size_t width, Height* __restrict out) {
  const Height *above = row - stride, *below = row + stride;
  for (std::size_t x = 0; x < width; ++x) {
    Height high = row[x], low = or_highest(row[x]);
    const auto take = [&](Height v) {
      high = std::max(high, v);
      low = std::min(low, or_highest(v));
    };
    take(*(row + x - 1));
    take(row[x + 1]);
    take(above[x]);
    take(below[x]);
    if (kAdjacency == Adjacency::eight) {
      take(*(above + x - 1));
      take(above[x + 1]);
      take(*(below + x - 1));
      take(below[x + 1]);
    }
    const std::uint32_t range = static_cast<std::uint32_t>(high) - static_cast<std::uint32_t>(low);
    out[x] = row[x] == kNoHeight ? kNoHeight : static_cast<Height>(range);
  }
}

}  // namespace

Image gradient(const Image& image, Adjacency adjacency) {
  const PaddedFrame frame(image.width, image.height);
  const auto heights = padded(image, kNoHeight);
  Image out{image.width, image.height, std::vector<Height>(image.size())};
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const Height* row = heights.data() + frame.row(y);
    Height* to = out.values.data() + std::size_t{y} * image.width;
    adjacency == Adjacency::four ? gradient_row<Adjacency::four>(row, frame.stride, image.width, to)
                                 : gradient_row<Adjacency::eight>(row, frame.stride, image.width, to);
  }
  return out;
}

}  // namespace ilot
