// SPDX-License-Identifier: Apache-2.0
// Inside of the raster kernels: what a tile's neighbours have to know of it.
#pragma once
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// The pixels on the border of an image, each once: the first row, the last, then what is left of the first column and
// of the last.
struct Perimeter {
  std::uint32_t width, height;

  std::uint32_t size() const {
    const std::uint32_t rows = height > 1 ? 2 : 1, columns = width > 1 ? 2 : 1;
    return width * rows + (height > 2 ? (height - 2) * columns : 0);
  }
  // (x, y) must lie on the border.
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

// Between two places a and b it takes `height` to get from one to the other.
struct SpillEdge {
  std::uint32_t a, b;
  Height height;
};

// The height of an image on its perimeter, pixel by pixel.
std::vector<Height> heights_on(const Perimeter& perimeter, const Image& image);

struct BorderFlood {
  Image level;                    // holes filled, with every pixel of the perimeter an outlet
  std::vector<SpillEdge> spills;  // at most the perimeter's size - 1, the lowest first
};

// Spill heights between all pixels of the perimeter, within the image: the least, over all paths, of the highest pixel
// on the path, is the highest edge on the path between the two in a tree, the spills. A flood from the whole perimeter,
// each pixel a basin of its own, meets the passes from the lowest up: those that join two trees are kept (Barnes 2016
// joins tiles by the graph of all of them). What is joined to the perimeter over pixels without a height is under water
// run by run. O(n log(range)).
BorderFlood flood_from_border(const Image& image, Adjacency adjacency);

}  // namespace ilot
