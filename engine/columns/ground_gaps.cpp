// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/ground_gaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/core/integers.h"

namespace ilot {
namespace {

struct Direction {
  int dx, dy;
};
// Counter-clockwise, so that opposite ones are four apart.
constexpr Direction kDirections[8] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

// What the eight directions give to each pixel.
struct Sums {
  std::vector<double> weight, height;
  std::vector<std::uint8_t> seen;  // a bit for each direction with a height
};

// Of one direction: pixels to the nearest height, and that height.
struct Nearest {
  std::vector<std::uint32_t> steps;
  std::vector<Height> height;
};

// Adds the nearest height in one direction to every pixel. The pixels are visited so that the next one in the direction
// comes before.
void add_direction(const Image& ground, int number, std::uint32_t reach, Nearest& nearest, Sums& sums) {
  const auto [dx, dy] = kDirections[number];
  const auto width = static_cast<std::int64_t>(ground.width), height = static_cast<std::int64_t>(ground.height);
  nearest.steps.assign(ground.size(), reach + 1);
  nearest.height.assign(ground.size(), kNoHeight);
  const bool forward = dy < 0 || (dy == 0 && dx < 0);
  for (std::int64_t n = 0; n < width * height; ++n) {
    const std::int64_t i = forward ? n : width * height - 1 - n;
    const auto at = static_cast<std::size_t>(i);
    if (ground.values[at] != kNoHeight) {
      nearest.steps[at] = 0;
      nearest.height[at] = ground.values[at];
      continue;
    }
    const std::int64_t x = i % width + dx, y = i / width + dy;
    if (x < 0 || y < 0 || x >= width || y >= height) continue;
    const auto next = static_cast<std::size_t>(y * width + x);
    if (nearest.steps[next] >= reach) continue;
    const std::uint32_t steps = nearest.steps[next] + 1;
    nearest.steps[at] = steps;
    nearest.height[at] = nearest.height[next];
    const double weight = 1 / (static_cast<double>(steps) * steps * (dx * dx + dy * dy));
    sums.weight[at] += weight;
    sums.height[at] += weight * nearest.height[at];
    sums.seen[at] = static_cast<std::uint8_t>(sums.seen[at] | 1u << number);
  }
}

bool between(std::uint8_t seen) {
  for (unsigned k = 0; k < 8; ++k)
    for (unsigned apart = 3; apart <= 5; ++apart)
      if ((seen >> k & 1) != 0 && (seen >> ((k + apart) % 8) & 1) != 0) return true;
  return false;
}

}  // namespace

Image filled_ground(const Image& ground, std::uint32_t reach) {
  Sums sums{std::vector<double>(ground.size()), std::vector<double>(ground.size()),
            std::vector<std::uint8_t>(ground.size())};
  Nearest nearest;
  for (int k = 0; k < 8; ++k) add_direction(ground, k, reach, nearest, sums);
  Image filled = ground;
  for (std::size_t i = 0; i < filled.size(); ++i)
    if (filled.values[i] == kNoHeight && between(sums.seen[i]))
      filled.values[i] = static_cast<Height>(std::lround(sums.height[i] / sums.weight[i]));
  return filled;
}

Image smoothed_fill(const Image& ground, Image filled) {
  const auto width = static_cast<std::int64_t>(ground.width), height = static_cast<std::int64_t>(ground.height);
  for (std::uint32_t round = 0; round < kSmoothings; ++round) {
    const Image before = filled;
    for (std::int64_t y = 0; y < height; ++y)
      for (std::int64_t x = 0; x < width; ++x) {
        const auto at = static_cast<std::size_t>(y * width + x);
        if (ground.values[at] != kNoHeight || before.values[at] == kNoHeight) continue;
        std::int64_t sum = 0, count = 0;
        for (std::int64_t v = std::max<std::int64_t>(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
          for (std::int64_t u = std::max<std::int64_t>(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
            if (const Height h = before.values[static_cast<std::size_t>(v * width + u)]; h != kNoHeight)
              sum += h, ++count;
        filled.values[at] = static_cast<Height>(floor_divided(sum, count));
      }
  }
  return filled;
}

}  // namespace ilot
