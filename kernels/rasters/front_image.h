// SPDX-License-Identifier: Apache-2.0
// A picture of a surface seen from the front: in each pixel the mean colour of what lies foremost.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ilot {

// A point that falls into a pixel (its index, row by row), `out` steps in front of the surface.
struct FrontPoint {
  std::uint32_t pixel = 0;
  std::int32_t out = 0;
  std::array<std::uint8_t, 3> colour{};
};

constexpr std::int32_t kNothingInFront = std::numeric_limits<std::int32_t>::min();

// 20 bytes a pixel. Fill it in two passes over the same points: all of keep_front, then all of add_colours.
struct FrontImage {
  explicit FrontImage(std::size_t pixels) : front(pixels, kNothingInFront), count(pixels, 0), sums(pixels) {}
  std::vector<std::int32_t> front;  // of the foremost point; kNothingInFront without one
  std::vector<std::uint32_t> count;
  std::vector<std::array<std::uint32_t, 3>> sums;
};

// Remembers the foremost point of each pixel. O(points); points and calls in any order give the same.
void keep_front(FrontImage& image, std::span<const FrontPoint> points);

// Sums colours of points at most `band` steps behind the foremost one of their pixel; up to 2^24 a pixel, those beyond
// are left out. O(points); points and calls in any order give the same below that number.
void add_colours(FrontImage& image, std::span<const FrontPoint> points, std::int32_t band);

// Red, green, blue and 255 for each pixel with points, four zeros for the others; means are rounded to the nearest.
std::vector<std::uint8_t> mean_colours(const FrontImage& image);

// Closes narrow gaps in a picture of four bytes a pixel: `rounds` times, every empty pixel of which three or more of
// the eight neighbours are not gets their mean; so a gap of two pixels a round closes, an opening only shrinks by one a
// round at its edge. Returns how many pixels were filled. O(rounds x pixels).
std::uint64_t fill_gaps(std::span<std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, int rounds);

}  // namespace ilot
