// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/point_sets.h"

namespace ilot {
namespace {

constexpr float kInfinity = INFINITY;

TEST(Grid, FourPointsByHand) {
  const auto set = test::make_set("four", {{0, 0, 5}, {9, 0, 7}, {10, 0, 1}, {3, 19, 2}});
  const GridFrame frame = frame_of(set.view(), 10);
  EXPECT_EQ(frame.width, 2u);
  EXPECT_EQ(frame.height, 2u);
  const GridHeights g = grid_heights(set.view(), frame);
  EXPECT_EQ(g.count, (std::vector<std::uint32_t>{2, 1, 1, 0}));
  EXPECT_EQ(g.low, (std::vector<float>{5, 1, 2, kInfinity}));
  EXPECT_EQ(g.high, (std::vector<float>{7, 1, 2, -kInfinity}));
}

TEST(Grid, NoPointsHaveAnEmptyFrame) {
  const GridFrame frame = frame_of({}, 10);
  EXPECT_EQ(frame.size(), 0u);
  EXPECT_TRUE(grid_heights({}, frame).count.empty());
}

// Oracle: integer division. Coordinates to the ends of the range, pixels of every kind, frames that cut points off.
TEST(Grid, PixelsEqualIntegerDivision) {
  Rng rng(3);
  constexpr std::size_t n = 4000;
  std::vector<float> x(n + 16), y(n + 16), z(n + 16);
  for (const std::int64_t pixel : {1, 2, 3, 7, 10, 1000, 4095, 99991, 16777216}) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto draw = [&] {
        const auto v = static_cast<std::int64_t>(rng.below(1 << 25)) - (1 << 24);
        return static_cast<float>(i % 3 == 0 ? v / pixel * pixel : i % 3 == 1 ? v % 5000 : v);  // borders, near, far
      };
      x[i] = draw();
      y[i] = draw();
    }
    const GridFrame frames[] = {{-16777216, -16777216, pixel, 60000, 60000}, {-300, 77, pixel, 100, 50000}};
    for (const GridFrame& frame : frames) {
      std::vector<std::uint32_t> got(n);
      pixels_of({x.data(), y.data(), z.data(), n}, frame, got);
      for (std::size_t i = 0; i < n; ++i) {
        const std::int64_t dx = static_cast<std::int64_t>(x[i]) - frame.x,
                           dy = static_cast<std::int64_t>(y[i]) - frame.y;
        const bool inside = dx >= 0 && dy >= 0 && dx / pixel < frame.width && dy / pixel < frame.height;
        const std::int64_t want = inside ? dy / pixel * frame.width + dx / pixel : std::int64_t{kNoPixel};
        ASSERT_EQ(std::int64_t{got[i]}, want) << x[i] << " " << y[i] << " pixel " << pixel;
      }
    }
  }
}

TEST(Grid, FramesHoldTheirPointsAndFitOnEachOther) {
  for (auto set : test::point_sets(300)) {
    for (std::size_t i = 0; i < set.size; ++i) set.x[i] -= 12345;
    for (const std::int64_t pixel : {1, 50, 7777}) {
      const GridFrame frame = frame_of(set.view(), pixel);
      if (frame.size() > (1u << 26)) continue;
      EXPECT_EQ(frame.x % pixel, 0);
      EXPECT_EQ(frame.y % pixel, 0);
      std::vector<std::uint32_t> pixels(set.size);
      pixels_of(set.view(), frame, pixels);
      EXPECT_EQ(std::count(pixels.begin(), pixels.end(), kNoPixel), 0) << set.name;
    }
  }
}

TEST(Grid, PartsMergeToTheWhole) {
  const auto set = test::point_sets(1000)[1];
  const GridFrame frame = frame_of(set.view(), 700);
  const Points p = set.view();
  GridHeights merged = grid_heights({p.x + 600, p.y + 600, p.z + 600, 400}, frame);
  merge(merged, grid_heights({p.x, p.y, p.z, 600}, frame));
  const GridHeights whole = grid_heights(p, frame);
  EXPECT_EQ(merged.count, whole.count);
  EXPECT_EQ(merged.low, whole.low);
  EXPECT_EQ(merged.high, whole.high);
}

}  // namespace
}  // namespace ilot
