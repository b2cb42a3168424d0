// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/folded_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace ilot {
namespace {

TEST(FoldedAxis, ByHand) {
  const std::vector<std::int64_t> tiles{-4, -3, -3, 2, 1000000, 1000002};
  const FoldedAxis axis(tiles, 6);
  EXPECT_TRUE(axis.is_folded());
  EXPECT_EQ(axis.size(), 7 + 6 + 3);
  EXPECT_EQ(axis.folded(-4), 0);
  EXPECT_EQ(axis.folded(2), 6);
  EXPECT_EQ(axis.folded(8), 12);  // of the gap that is kept
  EXPECT_EQ(axis.folded(9), -1);
  EXPECT_EQ(axis.folded(999999), -1);
  EXPECT_EQ(axis.folded(1000000), 13);
  EXPECT_EQ(axis.folded(1000002), 15);
  EXPECT_EQ(axis.folded(1000003), -1);
  EXPECT_EQ(axis.folded(-5), -1);
  EXPECT_EQ(axis.lattice(-1), -5);
  EXPECT_EQ(axis.lattice(12), 8);
  EXPECT_EQ(axis.lattice(13), 1000000);
  EXPECT_EQ(axis.lattice(16), 1000003);
}

TEST(FoldedAxis, NarrowGapsStay) {
  const std::vector<std::int64_t> tiles{10, 17};
  const FoldedAxis axis(tiles, 6);
  EXPECT_FALSE(axis.is_folded());
  EXPECT_EQ(axis.size(), 8);
  for (std::int64_t tile = 10; tile <= 17; ++tile) {
    EXPECT_EQ(axis.folded(tile), tile - 10);
    EXPECT_EQ(axis.lattice(tile - 10), tile);
  }
  EXPECT_EQ(FoldedAxis().size(), 0);
  EXPECT_EQ(FoldedAxis().folded(0), -1);
}

// Whatever the tiles: the way back leads where it came from, and the order stays.
TEST(FoldedAxis, ThereAndBack) {
  std::vector<std::int64_t> tiles;
  for (std::int64_t i = 0; i < 60; ++i) tiles.push_back(i * i * i * (i % 3 + 1) - 7);
  std::sort(tiles.begin(), tiles.end());
  const FoldedAxis axis(tiles, 20);
  std::int64_t before = -1, last = std::numeric_limits<std::int64_t>::min();
  for (const std::int64_t tile : tiles) {
    const std::int64_t folded = axis.folded(tile);
    EXPECT_EQ(axis.lattice(folded), tile);
    if (tile != last) {
      EXPECT_GT(folded, before);
    }
    if (before >= 0) {
      EXPECT_EQ(folded - before, std::min<std::int64_t>(tile - last, 21));
    }
    before = folded;
    last = tile;
  }
  EXPECT_EQ(axis.size(), before + 1);
}

}  // namespace
}  // namespace ilot
