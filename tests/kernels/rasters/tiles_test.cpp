// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/tiles.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"
#include "kernels/morphology/flat_zones.h"
#include "tests/support/image_tiles.h"

namespace ilot {
namespace {

// Oracle: a flag for every place of the bounding box.
struct DenseTiles {
  std::uint32_t width, height, side;
  std::vector<std::uint8_t> present;

  std::int64_t columns() const { return (width + side - 1) / side; }
  bool contains(std::int64_t x, std::int64_t y) const {
    return x >= 0 && y >= 0 && x < width && y < height &&
           present[static_cast<std::size_t>(y / side * columns() + x / side)] != 0;
  }
  bool ends_at(std::int64_t x, std::int64_t y) const {
    for (std::int64_t v = y - 1; v <= y + 1; ++v)
      for (std::int64_t u = x - 1; u <= x + 1; ++u)
        if (!contains(u, v)) return true;
    return false;
  }
};

TEST(TileGrid, EqualsAFlagForEveryPlace) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Rng rng(seed, 1);
    DenseTiles dense{23, 17, static_cast<std::uint32_t>(1 + seed % 7), {}};
    const TileGrid all{dense.width, dense.height, dense.side};
    for (std::size_t t = 0; t < all.count(); ++t) dense.present.push_back(rng.below(3) != 0);
    dense.present[rng.below(dense.present.size())] = 1;
    const TileGrid grid = test::with_tiles(all, dense.present);
    for (std::int64_t y = -2; y < 20; ++y)
      for (std::int64_t x = -2; x < 26; ++x) {
        ASSERT_EQ(grid.contains(x, y), dense.contains(x, y)) << seed << " " << x << " " << y;
        if (dense.contains(x, y)) {
          ASSERT_EQ(grid.ends_at(x, y), dense.ends_at(x, y)) << seed << " " << x << " " << y;
        }
      }
    std::size_t number = 0;  // row by row, absent ones have none
    for (std::size_t t = 0; t < all.count(); ++t) {
      if (dense.present[t] == 0) continue;
      const TileFrame got = tile_frame(grid, number), want = tile_frame(all, t);
      EXPECT_EQ(got.x, want.x);
      EXPECT_EQ(got.y, want.y);
      EXPECT_EQ(got.width, want.width);
      EXPECT_EQ(got.height, want.height);
      EXPECT_EQ(grid.tile_with(want.x, want.y), number);
      ++number;
    }
    EXPECT_EQ(grid.count(), number);
  }
}

TEST(TileGrid, GroupsAreThoseThatTouch) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed, 2);
    const TileGrid all{40, 30, 3};
    std::vector<std::uint8_t> present;
    Image image = filled_image(all.columns(), all.rows(), kNoHeight);
    for (std::size_t t = 0; t < all.count(); ++t) present.push_back(rng.below(3) == 0);
    present[7] = 1;
    for (std::size_t t = 0; t < all.count(); ++t)
      if (present[t] != 0) image.values[t] = 0;
    const PixelLabels want = flat_zones(image, 0, Adjacency::eight);
    const TileGroups groups = groups_of(test::with_tiles(all, present));
    EXPECT_EQ(groups.count, want.count);
    std::vector<std::uint32_t> of;
    for (std::size_t t = 0; t < all.count(); ++t)
      if (present[t] != 0) of.push_back(want.of[t]);
    EXPECT_EQ(groups.of, of) << seed;
  }
}

}  // namespace
}  // namespace ilot
