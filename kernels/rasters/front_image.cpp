// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/front_image.h"

#include <algorithm>
#include <utility>

namespace ilot {
namespace {

constexpr std::uint32_t kMostPerPixel = 1u << 24;  // times 255 fits 32 bits
constexpr std::uint32_t kLeastNeighbours = 3;

struct Filling {
  std::size_t pixel = 0;
  std::array<std::uint8_t, 3> colour{};
};

// Computes the mean of the neighbours that are not empty, when there are enough.
bool mean_of_neighbours(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, std::uint32_t x,
                        std::uint32_t y, Filling& filling) {
  std::array<std::uint32_t, 3> sums{};
  std::uint32_t count = 0;
  for (std::uint32_t ny = y == 0 ? 0 : y - 1; ny <= std::min(y + 1, height - 1); ++ny)
    for (std::uint32_t nx = x == 0 ? 0 : x - 1; nx <= std::min(x + 1, width - 1); ++nx) {
      const std::size_t at = 4 * (static_cast<std::size_t>(ny) * width + nx);
      if (rgba[at + 3] == 0) continue;
      ++count;
      for (std::size_t c = 0; c < 3; ++c) sums[c] += rgba[at + c];
    }
  if (count < kLeastNeighbours) return false;
  filling.pixel = static_cast<std::size_t>(y) * width + x;
  for (std::size_t c = 0; c < 3; ++c) filling.colour[c] = static_cast<std::uint8_t>((sums[c] + count / 2) / count);
  return true;
}

}  // namespace

void keep_front(FrontImage& image, std::span<const FrontPoint> points) {
  for (const FrontPoint& p : points) image.front[p.pixel] = std::max(image.front[p.pixel], p.out);
}

void add_colours(FrontImage& image, std::span<const FrontPoint> points, std::int32_t band) {
  for (const FrontPoint& p : points) {
    if (static_cast<std::int64_t>(image.front[p.pixel]) - p.out > band || image.count[p.pixel] == kMostPerPixel)
      continue;
    ++image.count[p.pixel];
    for (std::size_t c = 0; c < 3; ++c) image.sums[p.pixel][c] += p.colour[c];
  }
}

std::vector<std::uint8_t> mean_colours(const FrontImage& image) {
  std::vector<std::uint8_t> rgba(4 * image.count.size(), 0);
  for (std::size_t i = 0; i < image.count.size(); ++i) {
    const std::uint64_t count = image.count[i];
    if (count == 0) continue;
    for (std::size_t c = 0; c < 3; ++c)
      rgba[4 * i + c] = static_cast<std::uint8_t>((image.sums[i][c] + count / 2) / count);
    rgba[4 * i + 3] = 255;
  }
  return rgba;
}

std::uint64_t fill_gaps(std::span<std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, int rounds) {
  std::uint64_t filled = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Filling> fillings;
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x) {
        Filling filling;
        if (rgba[4 * (static_cast<std::size_t>(y) * width + x) + 3] == 0 &&
            mean_of_neighbours(rgba, width, height, x, y, filling))
          fillings.push_back(filling);
      }
    for (const Filling& f : fillings) {
      for (std::size_t c = 0; c < 3; ++c) rgba[4 * f.pixel + c] = f.colour[c];
      rgba[4 * f.pixel + 3] = 255;
    }
    filled += fillings.size();
    if (fillings.empty()) break;
  }
  return filled;
}

}  // namespace ilot
