// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/tile_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

double size_of(const TileItem& item) {
  return norm(item.box.max - item.box.min);
}

std::vector<TileItem> town(std::uint64_t seed, std::size_t count, double width) {
  Rng rng(seed);
  std::vector<TileItem> items;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 low{width * rng.uniform(), width * rng.uniform(), 0};
    const double size = 1 + 40 * rng.uniform();
    items.push_back({{low, low + Vec3{size, size, size}}, 10 + static_cast<std::uint32_t>(90 * rng.uniform())});
  }
  return items;
}

// Every item is in one tile; tiles are not too full; what a tile shows is as large as all that its children show, and
// its box holds them.
void check(const std::vector<TileItem>& items, const TileTreeParams& params) {
  const std::vector<ModelTile> tiles = tile_tree(items, params);
  std::set<std::uint32_t> seen;
  std::vector<int> parents(tiles.size());
  for (const ModelTile& tile : tiles) {
    std::size_t triangles = 0;
    for (const std::uint32_t i : tile.items) {
      EXPECT_TRUE(seen.insert(i).second);
      EXPECT_GE(size_of(items[i]), tile.missing_m);
      EXPECT_TRUE(tile.box.contains(items[i].box.min) && tile.box.contains(items[i].box.max));
      triangles += items[i].triangles;
    }
    if (tile.items.size() > 1) {
      EXPECT_LE(triangles, params.most_triangles);
    }
    double missing = 0;
    for (const std::uint32_t child : tile.children) {
      ++parents[child];
      EXPECT_TRUE(tile.box.contains(tiles[child].box.min) && tile.box.contains(tiles[child].box.max));
      EXPECT_LE(tiles[child].missing_m, tile.missing_m);
      for (const std::uint32_t i : tiles[child].items) missing = std::max(missing, size_of(items[i]));
    }
    if (!tile.items.empty()) {
      EXPECT_EQ(tile.missing_m, missing);
    }
  }
  EXPECT_EQ(seen.size(), items.size());
  for (std::size_t i = 0; i < tiles.size(); ++i) EXPECT_EQ(parents[i], i > 0 ? 1 : 0);
}

TEST(TileTree, ShowsEveryItemOnceLargestFirst) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) check(town(seed, 300, 2000), {1000, 16000});
}

TEST(TileTree, NoTileOfAWideTownShowsItemsFarFromItsMiddle) {
  const std::vector<TileItem> items = town(1, 300, 60000);
  check(items, {1000, 16000});
  for (const ModelTile& tile : tile_tree(items, {1000, 16000}))
    if (!tile.items.empty()) {
      EXPECT_LT(tile.box.max.x - tile.box.min.x, 16000 + 100);
    }
}

TEST(TileTree, EndsWhereAllItemsAreAtOnePlace) {
  check(std::vector<TileItem>(50, TileItem{{{1, 2, 3}, {4, 5, 6}}, 900}), {1000000, 16000});
  EXPECT_EQ(tile_tree(std::vector<TileItem>(50, TileItem{{{1, 2, 3}, {4, 5, 6}}, 900}), {1000, 16000}).size(), 1u);
  EXPECT_TRUE(tile_tree({}, {}).empty());
}

}  // namespace
}  // namespace ilot
