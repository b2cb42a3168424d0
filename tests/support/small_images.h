// SPDX-License-Identifier: Apache-2.0
// Small images for oracles, and the symmetries that every raster kernel must respect. Each kind of image tests a
// different difficulty.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "kernels/core/rng.h"
#include "kernels/rasters/image.h"

namespace ilot::test {

struct NamedImage {
  std::string name;
  Image image;
};

constexpr Adjacency kAdjacencies[] = {Adjacency::four, Adjacency::eight};

// Heights are 0 to bound - 1. One pixel in `one_missing_in` has no height (0: every pixel has one).
inline Image random_image(std::uint32_t width, std::uint32_t height, std::uint32_t bound, std::uint64_t seed,
                          std::uint32_t one_missing_in = 0) {
  Rng rng(seed, std::uint64_t{width} << 32 | height);
  Image image = filled_image(width, height, 0);
  for (Height& v : image.values) {
    v = static_cast<Height>(rng.below(bound));
    if (one_missing_in != 0 && rng.below(one_missing_in) == 0) v = kNoHeight;
  }
  return image;
}

// Returns a winding corridor of height 0 between walls of 9. Kernels that only scan need many scans for it.
inline Image winding_image(std::uint32_t side) {
  Image image = filled_image(side, side, 9);
  for (std::uint32_t y = 1; y + 1 < side; ++y)
    for (std::uint32_t x = 1; x + 1 < side; ++x)
      if (y % 2 == 1 || x == (y % 4 == 2 ? 1 : side - 2)) image.values[y * side + x] = 0;
  image.values[side] = 0;  // the only exit
  return image;
}

inline std::vector<NamedImage> small_images() {
  std::vector<NamedImage> list{{"empty", {}},
                               {"one pixel", filled_image(1, 1, 5)},
                               {"one missing", filled_image(1, 1, kNoHeight)},
                               {"flat", filled_image(7, 5, -3)},
                               {"all missing", filled_image(4, 6, kNoHeight)},
                               {"row", random_image(23, 1, 6, 1)},
                               {"column", random_image(1, 19, 6, 2)},
                               {"two rows", random_image(17, 2, 9, 3, 5)},
                               {"winding", winding_image(21)}};
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const std::string number = " " + std::to_string(seed);
    list.push_back({"two heights" + number, random_image(19, 14, 2, seed)});
    list.push_back({"few heights" + number, random_image(16, 21, 4, seed, 6)});
    list.push_back({"many heights" + number, random_image(24, 18, 1000, seed)});
    list.push_back({"holes" + number, random_image(20, 20, 50, seed, 2)});
    Image wide = random_image(13, 11, 1u << 30, seed, 9);
    for (Height& v : wide.values)
      if (v % 2 == 1) v = -v;
    list.push_back({"wide" + number, wide});
  }
  return list;
}

inline Image transposed(const Image& image) {
  Image out{image.height, image.width, std::vector<Height>(image.size())};
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x)
      out.values[std::size_t{x} * image.height + y] = image.values[std::size_t{y} * image.width + x];
  return out;
}

inline Image mirrored(const Image& image) {
  Image out = image;
  for (std::uint32_t y = 0; y < image.height; ++y)
    std::reverse(out.values.begin() + std::ptrdiff_t{y} * image.width,
                 out.values.begin() + std::ptrdiff_t{y + 1} * image.width);
  return out;
}

// Raises every pixel that has a height.
inline Image raised(Image image, Height by) {
  for (Height& v : image.values)
    if (v != kNoHeight) v += by;
  return image;
}

// Returns the indices of the neighbours of pixel (x, y) by comparing bounds. Only the oracles use this method.
inline std::vector<std::size_t> neighbours_of(std::uint32_t width, std::uint32_t height, std::size_t pixel,
                                              Adjacency adjacency) {
  const auto x = static_cast<std::int64_t>(pixel % width), y = static_cast<std::int64_t>(pixel / width);
  std::vector<std::size_t> list;
  for (std::int64_t dy = -1; dy <= 1; ++dy) {
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      if ((dx == 0 && dy == 0) || (adjacency == Adjacency::four && dx != 0 && dy != 0)) continue;
      const std::int64_t qx = x + dx, qy = y + dy;
      if (qx < 0 || qy < 0 || qx >= width || qy >= height) continue;
      list.push_back(static_cast<std::size_t>(qy * width + qx));
    }
  }
  return list;
}

}  // namespace ilot::test
