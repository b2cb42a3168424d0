// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/reconstruct.h"

#include <gtest/gtest.h>

#include "tests/support/small_images.h"

namespace ilot {
namespace {

using test::kAdjacencies;

// Oracle: erosion by the elementary neighbourhood, never below the mask, all pixels at once, until nothing changes.
Image eroded_until_stable(const Image& marker, const Image& mask, Adjacency adjacency) {
  Image g = marker;
  for (std::size_t i = 0; i < g.size(); ++i) g.values[i] = std::max(g.values[i], mask.values[i]);
  for (bool changed = true; changed;) {
    const Image before = g;
    changed = false;
    for (std::size_t i = 0; i < g.size(); ++i) {
      Height least = before.values[i];
      for (const std::size_t q : test::neighbours_of(g.width, g.height, i, adjacency))
        least = std::min(least, before.values[q]);
      g.values[i] = std::max(least, mask.values[i]);
      changed |= g.values[i] != before.values[i];
    }
  }
  return g;
}

Image turned_over(Image image) {
  for (Height& v : image.values) v = ~v;
  return image;
}

Image marker_for(const Image& mask, std::uint64_t seed) {
  Image marker = mask;
  Rng rng(seed, mask.size());
  for (Height& v : marker.values) {
    const auto draw = rng.below(10);
    v = draw == 0 ? v : draw < 4 ? static_cast<Height>(rng.below(1200)) - 100 : kAboveAll;
  }
  return marker;
}

TEST(Reconstruct, AValleyByHand) {
  const Image mask{7, 1, {5, 1, 4, 0, 3, 2, 6}};
  const Image marker{7, 1, {5, kAboveAll, kAboveAll, kAboveAll, kAboveAll, 2, kAboveAll}};
  const Image got = reconstruct_by_erosion(marker, mask, Adjacency::four);
  EXPECT_EQ(got.values, (std::vector<Height>{5, 4, 4, 3, 3, 2, 6}));
}

TEST(Reconstruct, EqualsErosionUntilStable) {
  for (const auto& [name, mask] : test::small_images()) {
    for (const Adjacency adjacency : kAdjacencies) {
      for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const Image marker = marker_for(mask, seed);
        ASSERT_EQ(reconstruct_by_erosion(marker, mask, adjacency).values,
                  eroded_until_stable(marker, mask, adjacency).values)
            << name;
      }
    }
  }
}

TEST(Reconstruct, DilationIsErosionUpsideDown) {
  for (const auto& [name, mask] : test::small_images()) {
    const Image marker = marker_for(mask, 7);
    for (const Adjacency adjacency : kAdjacencies) {
      const Image want = turned_over(eroded_until_stable(turned_over(marker), turned_over(mask), adjacency));
      ASSERT_EQ(reconstruct_by_dilation(marker, mask, adjacency).values, want.values) << name;
    }
  }
}

TEST(Reconstruct, FollowsTransposingAndMirroring) {
  for (const auto& [name, mask] : test::small_images()) {
    const Image marker = marker_for(mask, 3);
    for (const Adjacency adjacency : kAdjacencies) {
      const Image got = reconstruct_by_erosion(marker, mask, adjacency);
      EXPECT_EQ(reconstruct_by_erosion(test::transposed(marker), test::transposed(mask), adjacency).values,
                test::transposed(got).values)
          << name;
      EXPECT_EQ(reconstruct_by_erosion(test::mirrored(marker), test::mirrored(mask), adjacency).values,
                test::mirrored(got).values)
          << name;
    }
  }
}

TEST(Reconstruct, TwiceIsOnce) {
  for (const auto& [name, mask] : test::small_images()) {
    const Image once = reconstruct_by_erosion(marker_for(mask, 5), mask, Adjacency::eight);
    EXPECT_EQ(reconstruct_by_erosion(once, mask, Adjacency::eight).values, once.values) << name;
  }
}

}  // namespace
}  // namespace ilot
