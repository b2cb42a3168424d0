// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/tile_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

bool at_one_place(const std::vector<TileItem>& items, const ModelTile& tile) {
  const Vec3 first = items[tile.items[0]].box.min;
  return std::all_of(tile.items.begin(), tile.items.end(),
                     [&](std::uint32_t i) { return norm(items[i].box.min - first) < 0.001; });
}

// Every item is in one tile, by its middle; tiles are not too full; what a tile shows is as large as all that its
// children show, and its box holds them.
void check(const std::vector<TileItem>& items, const TileTreeParams& params) {
  const ModelTree tree = tile_tree(items, params);
  const std::vector<ModelTile>& tiles = tree.tiles;
  std::set<std::uint32_t> seen;
  std::vector<int> parents(tiles.size());
  for (const ModelTile& tile : tiles) {
    std::size_t triangles = 0;
    const double width = std::ldexp(tree.width, -static_cast<int>(tile.level));
    for (const std::uint32_t i : tile.items) {
      const Vec3 middle = 0.5 * (items[i].box.min + items[i].box.max);
      EXPECT_NEAR(middle.x, tree.x + (tile.x + 0.5) * width, 0.5 * width + 1e-6);
      EXPECT_NEAR(middle.y, tree.y + (tile.y + 0.5) * width, 0.5 * width + 1e-6);
      EXPECT_TRUE(seen.insert(i).second);
      EXPECT_GE(size_of(items[i]), tile.missing_m);
      EXPECT_TRUE(tile.box.contains(items[i].box.min) && tile.box.contains(items[i].box.max));
      triangles += items[i].triangles;
    }
    if (tile.items.size() > 1 && !at_one_place(items, tile)) {
      EXPECT_LE(triangles, params.most_triangles);
    }
    double missing = 0;
    for (const std::uint32_t child : tile.children) {
      ++parents[child];
      EXPECT_EQ(tiles[child].level, tile.level + 1);
      EXPECT_EQ(tiles[child].x / 2, tile.x);
      EXPECT_EQ(tiles[child].y / 2, tile.y);
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
  for (const ModelTile& tile : tile_tree(items, {1000, 16000}).tiles)
    if (!tile.items.empty()) {
      EXPECT_LT(tile.box.max.x - tile.box.min.x, 16000 + 100);
    }
}

TEST(TileTree, EndsWhereAllItemsAreAtOnePlace) {
  check(std::vector<TileItem>(50, TileItem{{{1, 2, 3}, {4, 5, 6}}, 900}), {1000000, 16000});
  EXPECT_EQ(tile_tree(std::vector<TileItem>(50, TileItem{{{1, 2, 3}, {4, 5, 6}}, 900}), {1000, 16000}).tiles.size(),
            1u);
  EXPECT_TRUE(tile_tree({}, {}).tiles.empty());
}

}  // namespace
}  // namespace ilot
