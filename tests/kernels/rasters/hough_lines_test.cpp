// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/hough_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "kernels/core/parallel.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

// Pixels whose centre lies within half a pixel of a line, all of one value.
void draw(Image& image, const ImageLine& line, Height value) {
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x)
      if (std::abs(line.nx * x + line.ny * y + line.d) <= 0.5) image.values[std::size_t{y} * image.width + x] = value;
}

ImageLine line_through(double degrees, double x, double y) {
  const double angle = degrees * M_PI / 180;
  const double nx = -std::sin(angle), ny = std::cos(angle);
  return {nx, ny, -(nx * x + ny * y)};
}

TEST(HoughLines, FindsALineOfAnyDirection) {
  for (const double degrees : {0.0, 1.3, 17.0, 44.9, 45.0, 60.2, 89.0, 90.0, 91.7, 123.4, 179.0}) {
    Image image = test::random_image(160, 120, 10, 3);  // noise below 10
    const ImageLine want = line_through(degrees, 80, 60);
    draw(image, want, 200);
    const auto lines = hough_lines(image, {.max_distance = 1});
    ASSERT_EQ(lines.size(), 1u);
    const ImageLine got = lines[0].line;
    // Drawn in whole pixels: half a pixel over the image's height is all that its direction can be off.
    EXPECT_LT(std::abs(got.nx * want.ny - got.ny * want.nx), 0.5 / 120) << degrees;
    EXPECT_LT(std::abs(got.nx * 80 + got.ny * 60 + got.d), 0.1) << degrees;
  }
}

// Oracle: votes in a map, each pixel for each direction by itself.
TEST(HoughLines, ThePeakHasTheMostVotes) {
  for (const auto& [name, image] : test::small_images()) {
    if (name.starts_with("wide")) continue;
    std::map<std::pair<int, long>, std::int64_t> votes;
    for (std::uint32_t y = 0; y < image.height; ++y)
      for (std::uint32_t x = 0; x < image.width; ++x) {
        const Height v = image.values[std::size_t{y} * image.width + x];
        for (int k = 0; v > 0 && k < 36; ++k) {
          const double angle = k * M_PI / 36;
          votes[{k, std::lround(std::floor(x * std::cos(angle) + y * std::sin(angle) + 0.5 + 1e-9))}] += v;
        }
      }
    std::int64_t most = 0;
    for (const auto& [cell, sum] : votes) most = std::max(most, sum);
    const auto lines = hough_lines(image, {.directions = 36, .max_distance = 0.75});
    ASSERT_EQ(lines.size(), most > 0 ? 1u : 0u) << name;
    // The pixels of the best cell lie within half a pixel of its line: the refined one holds nearly as much.
    if (most == 0) continue;
    EXPECT_GE(lines[0].weight, 0.8 * static_cast<double>(most)) << name;
  }
}

TEST(HoughLines, SeveralStrongestFirstAndWeakOnesLeft) {
  Image image = filled_image(200, 150, 0);
  const ImageLine a = line_through(3, 100, 40), b = line_through(95, 60, 75), c = line_through(40, 150, 100);
  draw(image, c, 20);
  draw(image, b, 150);
  draw(image, a, 200);
  const auto lines = hough_lines(image, {.max_lines = 5, .least_share = 0.3});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_GT(std::abs(lines[0].line.nx * a.nx + lines[0].line.ny * a.ny), 0.9999);
  EXPECT_GT(std::abs(lines[1].line.nx * b.nx + lines[1].line.ny * b.ny), 0.9999);
  EXPECT_LT(lines[0].rms, 0.5);
}

TEST(HoughLines, NothingToVote) {
  EXPECT_TRUE(hough_lines({}).empty());
  EXPECT_TRUE(hough_lines(filled_image(5, 4, 0)).empty());
  EXPECT_TRUE(hough_lines(filled_image(5, 4, kNoHeight)).empty());
  EXPECT_EQ(hough_lines(filled_image(1, 1, 7)).size(), 1u);
}

TEST(HoughLines, ThreadsDoNotShow) {
  const Image image = test::random_image(90, 70, 1000, 5);
  std::vector<HoughLine> one, three;
  with_threads(1, [&] { one = hough_lines(image, {.max_lines = 3}); });
  with_threads(3, [&] { three = hough_lines(image, {.max_lines = 3}); });
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].line.nx, three[i].line.nx);
    EXPECT_EQ(one[i].line.d, three[i].line.d);
    EXPECT_EQ(one[i].weight, three[i].weight);
  }
}

}  // namespace
}  // namespace ilot
