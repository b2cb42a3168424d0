// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/perimeter.h"

#include <gtest/gtest.h>

#include "kernels/morphology/reconstruct.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

TEST(Perimeter, ListsEveryBorderPixelOnce) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 5u}, {6u, 1u}, {2u, 2u}, {2u, 5u}, {5u, 2u}, {4u, 7u}}) {
    const Perimeter perimeter{width, height};
    std::size_t border = 0;
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x) {
        if (x != 0 && y != 0 && x + 1 != width && y + 1 != height) continue;
        ++border;
        const std::uint32_t i = perimeter.index(x, y);
        ASSERT_LT(i, perimeter.size());
        const auto place = perimeter.place(i);
        EXPECT_EQ(place.x, x);
        EXPECT_EQ(place.y, y);
      }
    EXPECT_EQ(border, perimeter.size()) << width << " x " << height;
  }
}

// Oracle: for one pixel of the perimeter at a time, reconstruction from it alone; in the tree, relaxing its edges until
// nothing changes.
TEST(BorderFlood, GivesTheSpillHeightBetweenAnyTwoPixels) {
  for (const test::NamedImage& named : test::small_images()) {
    const auto& name = named.name;
    const Image& image = named.image;
    if (image.size() == 0) continue;
    const Perimeter perimeter{image.width, image.height};
    const auto at = [&](std::uint32_t i) {
      const auto [x, y] = perimeter.place(i);
      return std::size_t{y} * image.width + x;
    };
    for (const Adjacency adjacency : test::kAdjacencies) {
      const BorderFlood flood = flood_from_border(image, adjacency);
      const auto& tree = flood.spills;
      EXPECT_EQ(tree.size() + 1, perimeter.size()) << name;
      Image border = filled_image(image.width, image.height, kAboveAll);
      for (std::uint32_t i = 0; i < perimeter.size(); ++i) border.values[at(i)] = image.values[at(i)];
      EXPECT_EQ(flood.level.values, reconstruct_by_erosion(border, image, adjacency).values) << name;
      EXPECT_TRUE(std::is_sorted(tree.begin(), tree.end(),
                                 [](const SpillEdge& a, const SpillEdge& b) { return a.height < b.height; }));
      for (std::uint32_t from = 0; from < perimeter.size(); from += 3) {
        Image marker = filled_image(image.width, image.height, kAboveAll);
        marker.values[at(from)] = image.values[at(from)];
        const Image want = reconstruct_by_erosion(marker, image, adjacency);
        std::vector<Height> got(perimeter.size(), kAboveAll);
        got[from] = image.values[at(from)];
        for (bool changed = true; changed;) {
          changed = false;
          for (const SpillEdge& e : tree)
            for (const auto& [a, b] : {std::pair{e.a, e.b}, {e.b, e.a}}) {
              const Height through = std::max(got[a], e.height);
              changed |= through < got[b];
              got[b] = std::min(got[b], through);
            }
        }
        for (std::uint32_t i = 0; i < perimeter.size(); ++i) ASSERT_EQ(got[i], want.values[at(i)]) << name;
      }
    }
  }
}

}  // namespace
}  // namespace ilot
