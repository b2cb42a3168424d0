// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/watershed.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/small_images.h"

namespace ilot {
namespace {

using test::kAdjacencies;

PixelLabels random_markers(const Image& image, std::uint32_t one_in, std::uint64_t seed) {
  PixelLabels markers{image.width, image.height, 5, std::vector<std::uint32_t>(image.size(), 0)};
  Rng rng(seed, image.size());
  for (std::uint32_t& label : markers.of)
    if (rng.below(one_in) == 0) label = 1 + static_cast<std::uint32_t>(rng.below(5));
  return markers;
}

// Oracle: the definition, level by level, step by step, over all pixels at once.
std::vector<std::uint32_t> basins_of(const Image& relief, const PixelLabels& markers, Adjacency adjacency) {
  std::vector<std::uint32_t> labels = markers.of;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (relief.values[i] == kNoHeight) labels[i] = 0;
  const std::set<Height> levels(relief.values.begin(), relief.values.end());
  for (const Height level : levels) {
    for (bool changed = true; changed;) {
      changed = false;
      const auto before = labels;
      for (std::size_t i = 0; i < labels.size(); ++i) {
        if (before[i] != 0 || relief.values[i] == kNoHeight || relief.values[i] > level) continue;
        for (const std::size_t q : test::neighbours_of(relief.width, relief.height, i, adjacency)) {
          if (before[q] == 0) continue;
          labels[i] = labels[i] == 0 ? before[q] : std::min(labels[i], before[q]);
          changed = true;
        }
      }
    }
  }
  return labels;
}

TEST(Watershed, TwoBasinsByHand) {
  const Image relief{7, 1, {0, 1, 4, 2, 2, 2, 0}};
  const PixelLabels markers{7, 1, 2, {1, 0, 0, 0, 0, 0, 2}};
  EXPECT_EQ(watershed(relief, markers, Adjacency::four).of, (std::vector<std::uint32_t>{1, 1, 1, 2, 2, 2, 2}));
  // On a plateau both spread alike; the pixel in the middle goes to the lower label.
  const Image flat = filled_image(7, 1, 3);
  EXPECT_EQ(watershed(flat, markers, Adjacency::four).of, (std::vector<std::uint32_t>{1, 1, 1, 1, 2, 2, 2}));
}

TEST(Watershed, EqualsItsDefinition) {
  for (const test::NamedImage& named : test::small_images()) {
    const auto& name = named.name;
    const Image& image = named.image;
    for (const Adjacency adjacency : kAdjacencies) {
      for (const std::uint32_t one_in : {4u, 25u, 150u}) {
        const PixelLabels markers = random_markers(image, one_in, one_in);
        ASSERT_EQ(watershed(image, markers, adjacency).of, basins_of(image, markers, adjacency)) << name;
      }
    }
  }
}

TEST(Watershed, FollowsTransposingMirroringAndConstants) {
  for (const test::NamedImage& named : test::small_images()) {
    const auto& name = named.name;
    const Image& image = named.image;
    if (name.starts_with("wide")) continue;  // 77 more would leave the range of heights
    const PixelLabels markers = random_markers(image, 30, 1);
    const auto as_image = [&](const std::vector<std::uint32_t>& of) {
      return Image{image.width, image.height, std::vector<Height>(of.begin(), of.end())};
    };
    const auto as_labels = [](const Image& i) {
      return PixelLabels{i.width, i.height, 5, std::vector<std::uint32_t>(i.values.begin(), i.values.end())};
    };
    const Image marked = as_image(markers.of), got = as_image(watershed(image, markers, Adjacency::eight).of);
    EXPECT_EQ(as_labels(test::transposed(got)).of,
              watershed(test::transposed(image), as_labels(test::transposed(marked)), Adjacency::eight).of)
        << name;
    EXPECT_EQ(as_labels(test::mirrored(got)).of,
              watershed(test::mirrored(image), as_labels(test::mirrored(marked)), Adjacency::eight).of)
        << name;
    EXPECT_EQ(watershed(test::raised(image, 77), markers, Adjacency::eight).of, as_labels(got).of) << name;
  }
}

}  // namespace
}  // namespace ilot
