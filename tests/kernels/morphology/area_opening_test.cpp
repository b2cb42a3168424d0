// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/area_opening.h"

#include <gtest/gtest.h>

#include <set>

#include "kernels/morphology/flat_zones.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

using test::kAdjacencies;

// Oracle: the image cut at each of its heights, parts that are too small thrown away, and the cuts stacked again.
Image opened_cut_by_cut(const Image& image, std::uint32_t area, Adjacency adjacency) {
  Image out = filled_image(image.width, image.height, kNoHeight);
  const std::set<Height> levels(image.values.begin(), image.values.end());
  for (const Height level : levels) {
    if (level == kNoHeight) continue;
    Image cut = image;
    for (Height& v : cut.values) v = v >= level ? 0 : kNoHeight;
    const PixelLabels parts = flat_zones(cut, 0, adjacency);
    const auto sizes = zone_sizes(parts);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (parts.of[i] != 0 && sizes[parts.of[i]] >= area) out.values[i] = level;
  }
  return out;
}

TEST(AreaOpening, PeaksByHand) {
  const Image image{8, 1, {1, 5, 1, 4, 6, 4, 1, 2}};
  EXPECT_EQ(area_opening(image, 2, Adjacency::four).values, (std::vector<Height>{1, 1, 1, 4, 4, 4, 1, 1}));
  EXPECT_EQ(area_opening(image, 3, Adjacency::four).values, (std::vector<Height>{1, 1, 1, 4, 4, 4, 1, 1}));
  EXPECT_EQ(area_opening(image, 4, Adjacency::four).values, (std::vector<Height>(8, 1)));
  EXPECT_EQ(area_opening(image, 9, Adjacency::four).values, (std::vector<Height>(8, kNoHeight)));
}

TEST(AreaOpening, EqualsTheStackOfOpenedCuts) {
  for (const auto& [name, image] : test::small_images())
    for (const Adjacency adjacency : kAdjacencies)
      for (const std::uint32_t area : {1u, 2u, 5u, 30u, 1000u})
        ASSERT_EQ(area_opening(image, area, adjacency).values, opened_cut_by_cut(image, area, adjacency).values)
            << name << " area " << area;
}

TEST(AreaOpening, FollowsSymmetriesAndConstants) {
  for (const auto& [name, image] : test::small_images()) {
    if (name.starts_with("wide")) continue;  // 77 more would leave the range of heights
    const Image got = area_opening(image, 6, Adjacency::eight);
    EXPECT_EQ(area_opening(test::transposed(image), 6, Adjacency::eight).values, test::transposed(got).values) << name;
    EXPECT_EQ(area_opening(test::mirrored(image), 6, Adjacency::eight).values, test::mirrored(got).values) << name;
    EXPECT_EQ(area_opening(test::raised(image, 77), 6, Adjacency::eight).values, test::raised(got, 77).values) << name;
    EXPECT_EQ(area_opening(got, 6, Adjacency::eight).values, got.values) << name;
  }
}

}  // namespace
}  // namespace ilot
