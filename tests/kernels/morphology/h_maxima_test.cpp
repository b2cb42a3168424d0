// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/h_maxima.h"

#include <gtest/gtest.h>

#include "tests/support/small_images.h"

namespace ilot {
namespace {

using test::kAdjacencies;

// Oracle: the pixels that paths from `start` reach without going below `floor`.
std::vector<std::size_t> reached(const Image& image, std::size_t start, Height floor, Adjacency adjacency) {
  std::vector<std::uint8_t> seen(image.size(), 0);
  std::vector<std::size_t> found{start};
  seen[start] = 1;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const std::size_t q : test::neighbours_of(image.width, image.height, found[i], adjacency)) {
      if (seen[q] != 0 || image.values[q] < floor || image.values[q] == kNoHeight) continue;
      seen[q] = 1;
      found.push_back(q);
    }
  }
  return found;
}

// The greatest level t <= f(p) at which the part above t that holds p rises to t + h at least; by trying every level.
Height lowered_by_definition(const Image& image, std::size_t p, Height h, Adjacency adjacency) {
  for (Height t = image.values[p];; --t) {
    for (const std::size_t q : reached(image, p, t, adjacency))
      if (image.values[q] >= t + h) return t;
  }
}

TEST(HMaxima, PeaksByHand) {
  const Image image{9, 1, {0, 3, 1, 7, 2, 6, 5, 6, 0}};
  // 3 rises by 2 above its pass; the two 6 by 4 above theirs.
  EXPECT_EQ(h_maxima(image, 2, Adjacency::four).values, (std::vector<Height>{0, 1, 1, 5, 2, 4, 4, 4, 0}));
  EXPECT_EQ(h_maxima(image, 4, Adjacency::four).values, (std::vector<Height>{0, 1, 1, 3, 2, 2, 2, 2, 0}));
  const PixelLabels maxima = regional_maxima(image, Adjacency::four);
  EXPECT_EQ(maxima.of, (std::vector<std::uint32_t>{0, 1, 0, 2, 0, 3, 0, 4, 0}));
}

TEST(HMaxima, EqualTheirDefinition) {
  for (const test::NamedImage& named : test::small_images()) {
    const auto& name = named.name;
    const Image& image = named.image;
    if (image.size() > 300 || name.starts_with("wide") || name.starts_with("many")) continue;
    for (const Adjacency adjacency : kAdjacencies) {
      for (const Height h : {0, 1, 3, 10}) {
        const Image got = h_maxima(image, h, adjacency);
        for (std::size_t i = 0; i < image.size(); ++i) {
          const Height want = image.values[i] == kNoHeight ? kNoHeight : lowered_by_definition(image, i, h, adjacency);
          ASSERT_EQ(got.values[i], want) << name << " h " << h << " pixel " << i;
        }
      }
    }
  }
}

TEST(HMaxima, FollowSymmetriesAndConstants) {
  for (const test::NamedImage& named : test::small_images()) {
    const auto& name = named.name;
    const Image& image = named.image;
    if (name.starts_with("wide")) continue;  // 77 more would leave the range of heights
    const Image got = h_maxima(image, 2, Adjacency::eight);
    EXPECT_EQ(h_maxima(test::transposed(image), 2, Adjacency::eight).values, test::transposed(got).values) << name;
    EXPECT_EQ(h_maxima(test::mirrored(image), 2, Adjacency::eight).values, test::mirrored(got).values) << name;
    EXPECT_EQ(h_maxima(test::raised(image, 77), 2, Adjacency::eight).values, test::raised(got, 77).values) << name;
  }
}

TEST(RegionalMaxima, AreTheZonesFromWhichNothingHigherIsReached) {
  for (const test::NamedImage& named : test::small_images()) {
    const auto& name = named.name;
    const Image& image = named.image;
    for (const Adjacency adjacency : kAdjacencies) {
      const PixelLabels got = regional_maxima(image, adjacency);
      std::uint32_t count = 0;
      std::vector<std::uint32_t> want(image.size(), 0);
      for (std::size_t i = 0; i < image.size(); ++i) {
        if (image.values[i] == kNoHeight || want[i] != 0) continue;
        const auto zone = reached(image, i, image.values[i], adjacency);
        const bool top =
            std::all_of(zone.begin(), zone.end(), [&](std::size_t q) { return image.values[q] == image.values[i]; });
        if (!top) continue;
        ++count;
        for (const std::size_t q : zone) want[q] = count;
      }
      ASSERT_EQ(got.of, want) << name;
      ASSERT_EQ(got.count, count) << name;
    }
  }
}

}  // namespace
}  // namespace ilot
