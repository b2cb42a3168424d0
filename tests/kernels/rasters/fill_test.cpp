// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/fill.h"

#include <gtest/gtest.h>

#include <set>

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
  EXPECT_EQ(fill_holes(bowl, Adjacency::four).values, (std::vector<Height>{9, 9, 9, 9, 9,  //
                                                                           9, 8, 8, 8, 9,  //
                                                                           9, 8, 8, 8, 6,  //
                                                                           9, 9, 9, 9, 9}));
  EXPECT_EQ(fill_holes(bowl, Adjacency::eight).values, (std::vector<Height>{9, 9, 9, 9, 9,  //
                                                                            9, 7, 7, 7, 9,  //
                                                                            9, 7, 7, 8, 6,  //
                                                                            9, 9, 9, 9, 9}));
}

TEST(FillHoles, EqualsAPriorityFlood) {
  for (const auto& [name, image] : test::small_images())
    for (const Adjacency adjacency : kAdjacencies)
      ASSERT_EQ(fill_holes(image, adjacency).values, flooded(image, adjacency).values) << name;
}

TEST(FillHoles, FollowsSymmetriesAndConstants) {
  for (const auto& [name, image] : test::small_images()) {
    if (name.starts_with("wide")) continue;  // 77 more would leave the range of heights
    for (const Adjacency adjacency : kAdjacencies) {
      const Image got = fill_holes(image, adjacency);
      EXPECT_EQ(fill_holes(test::transposed(image), adjacency).values, test::transposed(got).values) << name;
      EXPECT_EQ(fill_holes(test::mirrored(image), adjacency).values, test::mirrored(got).values) << name;
      EXPECT_EQ(fill_holes(test::raised(image, 77), adjacency).values, test::raised(got, 77).values) << name;
      EXPECT_EQ(fill_holes(got, adjacency).values, got.values) << name;
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
    const Image got = fill_missing(image);
    for (std::size_t i = 0; i < image.size(); ++i) {
      const Height want = image.values[i] == kNoHeight ? level_around(image, i) : image.values[i];
      ASSERT_EQ(got.values[i], want) << name << " pixel " << i;
    }
  }
}

TEST(FillMissing, FollowsSymmetries) {
  for (const auto& [name, image] : test::small_images()) {
    const Image got = fill_missing(image);
    EXPECT_EQ(fill_missing(test::transposed(image)).values, test::transposed(got).values) << name;
    EXPECT_EQ(fill_missing(test::mirrored(image)).values, test::mirrored(got).values) << name;
  }
}

}  // namespace
}  // namespace ilot
