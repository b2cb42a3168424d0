// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/oracles/whole_fill.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

using test::kAdjacencies;

bool on_border(const Image& image, std::size_t i) {
  const std::size_t x = i % image.width, y = i / image.width;
  return x == 0 || y == 0 || x + 1 == image.width || y + 1 == image.height;
}

// Oracle: Dijkstra from the border, one pixel after the other out of an ordered set (priority flood, Barnes 2014).
Image flooded(const Image& image, Adjacency adjacency) {
  Image out = filled_image(image.width, image.height, kAboveAll);
  std::set<std::pair<Height, std::size_t>> open;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (!on_border(image, i)) continue;
    out.values[i] = image.values[i];
    open.insert({image.values[i], i});
  }
  while (!open.empty()) {
    const auto [height, p] = *open.begin();
    open.erase(open.begin());
    for (const std::size_t q : test::neighbours_of(image.width, image.height, p, adjacency)) {
      const Height through = std::max(height, image.values[q]);
      if (through >= out.values[q]) continue;
      open.erase({out.values[q], q});
      out.values[q] = through;
      open.insert({through, q});
    }
  }
  return out;
}

TEST(FillHoles, ABowlByHand) {
  const Image bowl{5, 4, {9, 9, 9, 9, 9,  //
                          9, 1, 2, 7, 9,  //
                          9, 3, 0, 8, 6,  //
                          9, 9, 9, 9, 9}};
  EXPECT_EQ(test::fill_holes(bowl, Adjacency::four).values, (std::vector<Height>{9, 9, 9, 9, 9,  //
                                                                                 9, 8, 8, 8, 9,  //
                                                                                 9, 8, 8, 8, 6,  //
                                                                                 9, 9, 9, 9, 9}));
  EXPECT_EQ(test::fill_holes(bowl, Adjacency::eight).values, (std::vector<Height>{9, 9, 9, 9, 9,  //
                                                                                  9, 7, 7, 7, 9,  //
                                                                                  9, 7, 7, 8, 6,  //
                                                                                  9, 9, 9, 9, 9}));
}

TEST(FillHoles, EqualsAPriorityFlood) {
  for (const auto& [name, image] : test::small_images())
    for (const Adjacency adjacency : kAdjacencies)
      ASSERT_EQ(test::fill_holes(image, adjacency).values, flooded(image, adjacency).values) << name;
}

TEST(FillHoles, FollowsSymmetriesAndConstants) {
  for (const auto& [name, image] : test::small_images()) {
    if (name.starts_with("wide")) continue;  // 77 more would leave the range of heights
    for (const Adjacency adjacency : kAdjacencies) {
      const Image got = test::fill_holes(image, adjacency);
      EXPECT_EQ(test::fill_holes(test::transposed(image), adjacency).values, test::transposed(got).values) << name;
      EXPECT_EQ(test::fill_holes(test::mirrored(image), adjacency).values, test::mirrored(got).values) << name;
      EXPECT_EQ(test::fill_holes(test::raised(image, 77), adjacency).values, test::raised(got, 77).values) << name;
      EXPECT_EQ(test::fill_holes(got, adjacency).values, got.values) << name;
    }
  }
}

// Oracle: a flood from every missing pixel, by recursion over a set.
Height level_around(const Image& image, std::size_t start) {
  std::set<std::size_t> region{start};
  std::vector<std::size_t> open{start};
  Height level = kAboveAll;
  while (!open.empty()) {
    const std::size_t p = open.back();
    open.pop_back();
    if (on_border(image, p)) return kNoHeight;
    for (const std::size_t q : test::neighbours_of(image.width, image.height, p, Adjacency::eight)) {
      if (image.values[q] != kNoHeight) level = std::min(level, image.values[q]);
      if (image.values[q] == kNoHeight && region.insert(q).second) open.push_back(q);
    }
  }
  return level;
}

TEST(FillMissing, EachRegionGetsTheLowestHeightAroundIt) {
  for (const auto& [name, image] : test::small_images()) {
    const Image got = test::fill_missing(image);
    for (std::size_t i = 0; i < image.size(); ++i) {
      const Height want = image.values[i] == kNoHeight ? level_around(image, i) : image.values[i];
      ASSERT_EQ(got.values[i], want) << name << " pixel " << i;
    }
  }
}

TEST(FillMissing, FollowsSymmetries) {
  for (const auto& [name, image] : test::small_images()) {
    const Image got = test::fill_missing(image);
    EXPECT_EQ(test::fill_missing(test::transposed(image)).values, test::transposed(got).values) << name;
    EXPECT_EQ(test::fill_missing(test::mirrored(image)).values, test::mirrored(got).values) << name;
  }
}

TEST(FillShortGaps, LinesByHand) {
  constexpr Height kNo = kNoHeight;
  const Image image{6,
                    2,
                    {4, kNo, kNo, 10, kNo, 99,  //
                     kNo, kNo, kNo, 9, 9, kNo}};
  EXPECT_EQ(fill_short_gaps(image, {2, 6}).values, (std::vector<Height>{4, 6, 8, 10, kNo, 99,  //
                                                                        kNo, kNo, kNo, 9, 9, kNo}));
  EXPECT_EQ(fill_short_gaps(image, {1, 6}).values, image.values);
  EXPECT_EQ(fill_short_gaps(image, {2, 5}).values, image.values);
}

// Oracle: from each pixel to its two ends, along both axes.
TEST(FillShortGaps, EqualALookFromEachPixel) {
  const ShortGapsParams params{3, 20};
  for (const auto& [name, image] : test::small_images()) {
    const Image got = fill_short_gaps(image, params);
    const auto w = std::int64_t{image.width}, h = std::int64_t{image.height};
    for (std::int64_t y = 0; y < h; ++y)
      for (std::int64_t x = 0; x < w; ++x) {
        const auto i = static_cast<std::size_t>(y * w + x);
        double want = INFINITY;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}}) {
          double end[2] = {0, 0}, away[2] = {0, 0};
          for (const int side : {0, 1}) {
            const int sign = side == 0 ? -1 : 1;
            for (std::int64_t u = x, v = y; u >= 0 && v >= 0 && u < w && v < h; u += sign * dx, v += sign * dy) {
              if (image.values[static_cast<std::size_t>(v * w + u)] == kNoHeight) continue;
              end[side] = image.values[static_cast<std::size_t>(v * w + u)];
              away[side] = static_cast<double>(std::abs(u - x) + std::abs(v - y));
              break;
            }
          }
          const double length = away[0] + away[1];
          if (away[0] == 0 || away[1] == 0 || length - 1 > params.longest) continue;
          if (std::abs(end[0] - end[1]) <= params.step)
            want = std::min(want, std::trunc((end[0] * away[1] + end[1] * away[0]) / length));
        }
        const bool stays = image.values[i] != kNoHeight || want == INFINITY;
        ASSERT_EQ(got.values[i], stays ? image.values[i] : static_cast<Height>(want)) << name;
      }
    EXPECT_EQ(fill_short_gaps(test::transposed(image), params).values, test::transposed(got).values) << name;
    EXPECT_EQ(fill_short_gaps(test::mirrored(image), params).values, test::mirrored(got).values) << name;
  }
}

}  // namespace
}  // namespace ilot
