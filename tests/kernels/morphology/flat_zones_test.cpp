// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/flat_zones.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/flooded_zones.h"

namespace ilot {
namespace {

using test::kAdjacencies;

TEST(FlatZones, StepsByHand) {
  const Image image{4,
                    3,
                    {0, 1, 5, 5,          //
                     2, kNoHeight, 6, 9,  //
                     3, 4, 4, 8}};
  const PixelLabels got = flat_zones(image, 1, Adjacency::four);
  EXPECT_EQ(got.of, (std::vector<std::uint32_t>{1, 1, 2, 2, 3, 0, 2, 4, 3, 3, 3, 4}));
  EXPECT_EQ(got.count, 4u);
}

TEST(FlatZones, EqualFloods) {
  for (const auto& [name, image] : test::small_images()) {
    for (const Adjacency adjacency : kAdjacencies) {
      for (const Height lambda : {0, 1, 40, 300, (1 << 30) - 1}) {
        const PixelLabels got = flat_zones(image, lambda, adjacency),
                          want = test::flooded_zones(image, lambda, adjacency);
        ASSERT_EQ(got.of, want.of) << name << " lambda " << lambda;
        ASSERT_EQ(got.count, want.count) << name;
      }
    }
  }
}

// The partition is the same in the mirror; only numbers follow the first pixels.
TEST(FlatZones, PartitionIsTheSameMirrored) {
  for (const auto& [name, image] : test::small_images()) {
    const PixelLabels got = flat_zones(image, 1, Adjacency::eight);
    const PixelLabels mirror = flat_zones(test::mirrored(image), 1, Adjacency::eight);
    EXPECT_EQ(got.count, mirror.count) << name;
    std::vector<std::uint32_t> other(got.count + 1, 0);
    for (std::size_t i = 0; i < got.of.size(); ++i) {
      const std::size_t row = i / image.width * image.width, m = row + (image.width - 1 - (i - row));
      std::uint32_t& partner = other[got.of[i]];
      if (partner == 0) partner = mirror.of[m];
      ASSERT_EQ(partner, mirror.of[m]) << name;
    }
  }
}

TEST(FlatZones, SizesAndLargest) {
  const Image image{5, 1, {1, 1, kNoHeight, 7, 7}};
  const PixelLabels labels = flat_zones(image, 0, Adjacency::four);
  EXPECT_EQ(zone_sizes(labels), (std::vector<std::uint32_t>{1, 2, 2}));
  EXPECT_EQ(largest_zone(labels), 1u);
  EXPECT_EQ(largest_zone(flat_zones(filled_image(3, 3, kNoHeight), 0, Adjacency::four)), 0u);
  EXPECT_EQ(largest_zone(flat_zones({}, 0, Adjacency::four)), 0u);
}

}  // namespace
}  // namespace ilot
