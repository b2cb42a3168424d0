// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/range_image.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/point_sets.h"

namespace ilot {
namespace {

void expect_equal(const RangeImage& got, const RangeImage& want) {
  EXPECT_EQ(got.range.values, want.range.values);
  EXPECT_EQ(got.accumulation, want.accumulation);
  EXPECT_EQ(got.frame.x, want.frame.x);
  EXPECT_EQ(got.frame.y, want.frame.y);
  EXPECT_EQ(got.frame.width, want.frame.width);
  EXPECT_EQ(got.frame.height, want.frame.height);
}

TEST(RangeImage, FourPointsByHand) {
  const auto set = test::make_set("four", {{0, 0, 5}, {9, 0, 7}, {10, 0, 1}, {3, 19, 2}});
  const RangeImage got = range_image(set.view(), frame_of(set.view(), 10));
  EXPECT_EQ(got.range.values, (std::vector<Height>{7, 1, 2, kNoHeight}));
  EXPECT_EQ(got.accumulation, (std::vector<std::uint32_t>{2, 1, 1, 0}));
}

TEST(RangeImage, NoPoints) {
  EXPECT_EQ(range_image({}, frame_of({}, 10)).range.size(), 0u);
  EXPECT_EQ(coarser(range_image({}, frame_of({}, 10)), 4).range.size(), 0u);
}

// Oracle: a map from pixel to its points.
TEST(RangeImage, EqualsAMapOfPixels) {
  for (auto set : test::point_sets(500)) {
    for (std::size_t i = 0; i < set.size; ++i) {
      set.x[i] -= 9001;
      set.z[i] -= 250;
    }
    const GridFrame frame = frame_of(set.view(), 50);
    if (frame.size() > (1u << 26)) continue;
    std::map<std::size_t, std::pair<Height, std::uint32_t>> pixels;
    for (std::size_t i = 0; i < set.size; ++i) {
      const auto column = (static_cast<std::int64_t>(set.x[i]) - frame.x) / frame.pixel;
      const auto row = (static_cast<std::int64_t>(set.y[i]) - frame.y) / frame.pixel;
      auto& [height, count] =
          pixels.try_emplace(static_cast<std::size_t>(row * frame.width + column), kNoHeight, 0).first->second;
      height = std::max(height, static_cast<Height>(set.z[i]));
      ++count;
    }
    const RangeImage got = range_image(set.view(), frame);
    for (std::size_t i = 0; i < frame.size(); ++i) {
      const auto found = pixels.find(i);
      ASSERT_EQ(got.range.values[i], found == pixels.end() ? kNoHeight : found->second.first) << set.name;
      ASSERT_EQ(got.accumulation[i], found == pixels.end() ? 0 : found->second.second) << set.name;
    }
  }
}

TEST(RangeImage, TilesMergeToTheWhole) {
  const auto set = test::point_sets(2000)[1];
  const Points p = set.view();
  const RangeImage whole = range_image(p, frame_of(p, 700));
  RangeImage merged = empty_range_image(whole.frame);
  for (std::size_t from = 0; from < 2000; from += 400) {
    const Points part{p.x + 1600 - from, p.y + 1600 - from, p.z + 1600 - from, 400};
    merge(merged, range_image(part, frame_of(part, 700)));  // each on a frame of its own
  }
  expect_equal(merged, whole);
  // What lies beyond a frame is left out, on every side.
  GridFrame inner = whole.frame;
  inner.x += 700 * 3;
  inner.y += 700 * 2;
  inner.width -= 5;
  inner.height -= 6;
  RangeImage cut = empty_range_image(inner);
  merge(cut, whole);
  expect_equal(cut, range_image(p, inner));
}

TEST(RangeImage, CoarserIsTheImageOfTheSamePoints) {
  for (auto set : test::point_sets(700)) {
    for (std::size_t i = 0; i < set.size; ++i) set.x[i] -= 12345;
    const GridFrame fine = frame_of(set.view(), 50);
    if (fine.size() > (1u << 26)) continue;
    for (const std::uint32_t factor : {1u, 3u, 4u})
      expect_equal(coarser(range_image(set.view(), fine), factor),
                   range_image(set.view(), frame_of(set.view(), 50 * factor)));
  }
}

}  // namespace
}  // namespace ilot
