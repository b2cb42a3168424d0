// SPDX-License-Identifier: Apache-2.0
// An image of a surface seen from the front. Each pixel has the mean colour of its foremost points.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ilot {

// A point in a pixel (its index, row by row), `out` steps in front of the surface.
struct FrontPoint {
  std::uint32_t pixel = 0;
  std::int32_t out = 0;
  std::array<std::uint8_t, 3> colour{};
};

constexpr std::int32_t kNothingInFront = std::numeric_limits<std::int32_t>::min();

// It needs 20 bytes per pixel. Fill it in two passes over the same points: first all calls of keep_front, then all
// calls of add_colours.
struct FrontImage {
  explicit FrontImage(std::size_t pixels) : front(pixels, kNothingInFront), count(pixels, 0), sums(pixels) {}
  std::vector<std::int32_t> front;  // of the foremost point; kNothingInFront without one
  std::vector<std::uint32_t> count;
  std::vector<std::array<std::uint32_t, 3>> sums;
};

// Keeps the foremost point of each pixel. The order of points and calls does not matter. O(points).
void keep_front(FrontImage& image, std::span<const FrontPoint> points);

// Adds the colours of points at most `band` steps behind the foremost one of their pixel. A pixel takes up to 2^24
// points, and further ones are left out. Below that number the order of points and calls does not matter. O(points).
void add_colours(FrontImage& image, std::span<const FrontPoint> points, std::int32_t band);

// Returns red, green, blue and 255 for each pixel with points and four zeros for the others. Means are rounded to the
// nearest integer.
std::vector<std::uint8_t> mean_colours(const FrontImage& image);

// Closes narrow gaps in an image of four bytes per pixel. In each round, every empty pixel with three or more filled
// pixels among its eight neighbours gets their mean. So a gap closes by two pixels in a round, and an opening shrinks
// by only one pixel at its edge in a round. Returns how many pixels were filled. O(rounds x pixels).
std::uint64_t fill_gaps(std::span<std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, int rounds);

}  // namespace ilot
