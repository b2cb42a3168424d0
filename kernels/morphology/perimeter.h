// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels: the data of a tile that its neighbours need.
#pragma once
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// The pixels on the border of an image, each once. The first row comes first, then the last row, then the rest of the
// first column and of the last column.
struct Perimeter {
  std::uint32_t width, height;

  std::uint32_t size() const {
    const std::uint32_t rows = height > 1 ? 2 : 1, columns = width > 1 ? 2 : 1;
    return width * rows + (height > 2 ? (height - 2) * columns : 0);
  }
  // (x, y) must be on the border.
  std::uint32_t index(std::uint32_t x, std::uint32_t y) const {
    if (y == 0) return x;
    if (y + 1 == height) return width + x;
    return 2 * width + (x == 0 ? 0 : height - 2) + y - 1;
  }
  struct Place {
    std::uint32_t x, y;
  };
  Place place(std::uint32_t index) const {
    if (index < width) return {index, 0};
    if (index < 2 * width && height > 1) return {index - width, height - 1};
    const std::uint32_t rest = index - 2 * width;
    return rest < height - 2 ? Place{0, rest + 1} : Place{width - 1, rest - (height - 2) + 1};
  }
};

// The way between the places a and b passes over `height`.
struct SpillEdge {
  std::uint32_t a, b;
  Height height;
};

// Returns the heights of an image on its perimeter, pixel by pixel.
std::vector<Height> heights_on(const Perimeter& perimeter, const Image& image);

struct BorderFlood {
  Image level;                    // the image with filled holes, where every pixel of the perimeter is an outlet
  std::vector<SpillEdge> spills;  // at most the perimeter's size - 1, the lowest first
};

// Computes the spill heights between all pixels of the perimeter, within the image. The spill height of two pixels is
// the least, over all paths, of the highest pixel on the path. It is the highest edge on the path between the two in
// the tree of spills. A flood starts from the whole perimeter, with each pixel a basin of its own. It meets the passes
// in rising order and keeps those that join two trees (Barnes 2016 joins tiles by the graph of all passes). The pixels
// without a height that are joined to the perimeter are flooded run by run. O(n log(range)).
BorderFlood flood_from_border(const Image& image, Adjacency adjacency);

}  // namespace ilot
