// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/tile_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ilot {
namespace {

// Items whose middles are this close are at one place: no square parts them. Derived: that is float32's rounding.
constexpr double kNarrowest = kVertexRounding;  // metres

struct Square {
  double x = 0, y = 0, width = 0;  // lower left corner
  std::uint32_t level = 0, column = 0, row = 0;
};

struct Work {
  const std::vector<TileItem>& items;
  const TileTreeParams& params;
  std::vector<ModelTile> tiles;
};

Vec3 middle(const Box3<Vec3>& box) {
  return 0.5 * (box.min + box.max);
}

double size_of(const TileItem& item) {
  return norm(item.box.max - item.box.min);
}

bool at_one_place(const Work& work, const std::vector<std::uint32_t>& items) {
  Box3<Vec3> middles = Box3<Vec3>::none();
  for (const std::uint32_t i : items) middles.add(middle(work.items[i].box));
  return std::max(middles.max.x - middles.min.x, middles.max.y - middles.min.y) <= kNarrowest;
}

// Returns how many of the items, which are sorted, the tile shows itself.
std::size_t shown(const Work& work, const std::vector<std::uint32_t>& items, const Square& square) {
  if (at_one_place(work, items)) return items.size();
  if (square.width > work.params.widest_m) return 0;
  std::size_t count = 0, triangles = 0;
  for (; count < items.size(); ++count) {
    triangles += work.items[items[count]].triangles;
    if (count > 0 && triangles > work.params.most_triangles) break;
  }
  return count;
}

Square quarter(const Square& square, std::uint32_t number) {
  const double half = square.width / 2;
  const std::uint32_t right = number & 1, upper = number >> 1;
  return {square.x + half * right, square.y + half * upper,   half,
          square.level + 1,        2 * square.column + right, 2 * square.row + upper};
}

std::uint32_t add_tile(Work& work, const std::vector<std::uint32_t>& items, const Square& square) {
  const auto number = static_cast<std::uint32_t>(work.tiles.size());
  work.tiles.emplace_back();
  const std::size_t own = shown(work, items, square);
  ModelTile tile{square.level, square.column, square.row, {}, {}, work.items[items[0]].box, 0};
  for (const std::uint32_t i : items) tile.box.add_box(work.items[i].box);
  tile.items.assign(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(own));
  if (own < items.size()) tile.missing_m = size_of(work.items[items[own]]);
  const double half = square.width / 2;
  std::array<std::vector<std::uint32_t>, 4> quarters;
  for (std::size_t k = own; k < items.size(); ++k) {
    const Vec3 at = middle(work.items[items[k]].box);
    quarters[(at.x >= square.x + half ? 1u : 0u) + (at.y >= square.y + half ? 2u : 0u)].push_back(items[k]);
  }
  for (std::uint32_t q = 0; q < quarters.size(); ++q)
    if (!quarters[q].empty()) tile.children.push_back(add_tile(work, quarters[q], quarter(square, q)));
  work.tiles[number] = std::move(tile);
  return number;
}

}  // namespace

ModelTree tile_tree(const std::vector<TileItem>& items, const TileTreeParams& params) {
  Work work{items, params, {}};
  if (items.empty()) return {};
  std::vector<std::uint32_t> order(items.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return size_of(items[a]) > size_of(items[b]); });
  Box3<Vec3> all = Box3<Vec3>::none();
  for (const TileItem& item : items) all.add_box(item.box);
  ModelTree tree;
  tree.x = all.min.x - kVertexRounding;
  tree.y = all.min.y - kVertexRounding;
  tree.width = std::max(all.max.x - all.min.x, all.max.y - all.min.y) + 2 * kVertexRounding;
  add_tile(work, order, {tree.x, tree.y, tree.width, 0, 0, 0});
  tree.tiles = std::move(work.tiles);
  return tree;
}

}  // namespace ilot
